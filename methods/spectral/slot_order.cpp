#include "methods/spectral/slot_order.h"

#include <span>
#include <tuple>

#include "common/finite_elements/compact_order.h"

namespace gibench::spectral {

void put_neighbours_together(const Nodes& nodes, std::size_t block, Partition& partition) {
  const auto position_of = [&](std::uint32_t node) { return nodes[node].position; };
  const auto before = [&](int axis, std::uint32_t a, std::uint32_t b) {
    const auto key = [&](std::uint32_t node) {
      const Vec3& p = nodes[node].position;
      return std::tuple(p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3], node);
    };
    return key(a) < key(b);
  };
  // Half of them, or as near to it as a block ends.
  const auto size_of_left = [block](std::size_t size, std::size_t first) {
    const std::size_t half = size / 2, end = (first + half + block / 2) / block * block;
    return end > first && end < first + size ? end - first : half;
  };
  for (std::size_t part = 0; part < partition.parts(); ++part)
    gibench::put_neighbours_together(std::span(partition.order).subspan(partition.part_begin[part], partition.part_size(part)),
                                     partition.part_begin[part], position_of, before, size_of_left);
}

}  // namespace gibench::spectral
