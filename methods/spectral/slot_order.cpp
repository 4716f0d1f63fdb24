#include "methods/spectral/slot_order.h"

#include <span>
#include <tuple>

#include "common/finite_elements/compact_order.h"

namespace gibench::spectral {

namespace {

/// `node_of(item)`: the node that an item of `items` stands for.
template <class NodeOf>
void order(const Nodes& nodes, std::size_t block, const NodeOf& node_of, std::span<std::uint32_t> items, std::size_t first_item) {
  const auto position_of = [&](std::uint32_t item) { return nodes[node_of(item)].position; };
  const auto before = [&](int axis, std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t item) {
      const Vec3 p = position_of(item);
      return std::tuple(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3], node_of(item));
    };
    return key(a) < key(b);
  };
  // Half of them, or as near to it as a block ends.
  const auto size_of_left = [block](std::size_t size, std::size_t first) {
    const std::size_t half = size / 2, end = (first + half + block / 2) / block * block;
    return end > first && end < first + size ? end - first : half;
  };
  gibench::put_neighbours_together(items, first_item, position_of, before, size_of_left);
}

}  // namespace

void put_neighbours_together(const Nodes& nodes, std::size_t block, Partition& partition) {
  for (std::size_t part = 0; part < partition.parts(); ++part)
    order(
        nodes, block, [](std::uint32_t node) { return node; },
        std::span(partition.order).subspan(partition.part_begin[part], partition.part_size(part)), partition.part_begin[part]);
}

void put_neighbours_together(const Nodes& nodes, std::size_t block, std::span<const std::uint32_t> node_of_slot,
                             std::span<std::uint32_t> slots) {
  order(
      nodes, block, [&](std::uint32_t slot) { return node_of_slot[slot]; }, slots, 0);
}

}  // namespace gibench::spectral
