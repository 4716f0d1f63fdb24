#include "methods/meshless/box_tree.h"

#include <numeric>

#include "common/finite_elements/compact_order.h"

namespace gibench::meshless {

namespace {

/// As many whole pieces as make a half; pieces are as long as the largest power of the tree's width below the run's size.
std::size_t half_of_pieces(std::size_t size, std::size_t /*first*/) {
  if (size <= tree_width) return 0;
  std::size_t piece = tree_width;
  while (piece * tree_width < size) piece *= tree_width;
  return (size + piece - 1) / piece / 2 * piece;
}

}  // namespace

std::vector<std::uint32_t> compact_order(std::span<const Vec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto before = [&](int axis, std::uint32_t a, std::uint32_t b) {
    const float at_a = positions[a][axis], at_b = positions[b][axis];
    return at_a != at_b ? at_a < at_b : a < b;
  };
  put_neighbours_together(
      std::span(order), 0, [&](std::uint32_t point) { return positions[point]; }, before, half_of_pieces);
  return order;
}

BoxTree::BoxTree(std::span<const Box> leaves) {
  std::vector<Box> boxes(leaves.begin(), leaves.end());
  while (!boxes.empty()) {
    first_node_.push_back(static_cast<std::uint32_t>(nodes_.size()));
    std::vector<Box> parents((boxes.size() + tree_width - 1) / tree_width);
    for (std::size_t parent = 0; parent < parents.size(); ++parent) {
      Node node;
      for (std::size_t i = 0; i < tree_width; ++i) {
        const std::size_t child = parent * tree_width + i;
        const Box box = child < boxes.size() ? boxes[child] : Box{};
        for (int axis = 0; axis < 3; ++axis) node.low[axis][i] = box.low[axis], node.high[axis][i] = box.high[axis];
        parents[parent].add(box);
      }
      nodes_.push_back(node);
    }
    if (parents.size() == 1) break;
    boxes = std::move(parents);
  }
  nodes_.shrink_to_fit();
}

}  // namespace gibench::meshless
