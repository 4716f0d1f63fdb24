#include "methods/meshless/box_tree.h"

#include <algorithm>
#include <numeric>

namespace gibench::meshless {

namespace {

Box box_of(std::span<const Vec3> positions, std::span<const std::uint32_t> order) {
  Box box;
  for (std::uint32_t i : order) box.add(positions[i], 0.0F);
  return box;
}

/// Orders [begin, end) of `order`, whose pieces are `piece` points long (a power of eight), then each piece.
void split(std::span<const Vec3> positions, std::span<std::uint32_t> order, std::size_t piece) {
  if (order.size() <= tree_width) return;
  while (piece >= order.size()) piece /= tree_width;
  const std::size_t pieces = (order.size() + piece - 1) / piece;
  const Box box = box_of(positions, order);
  const Vec3 size = box.high - box.low;
  const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
  const std::size_t left = pieces / 2 * piece;
  std::nth_element(order.begin(), order.begin() + static_cast<std::ptrdiff_t>(left), order.end(),
                   [&](std::uint32_t a, std::uint32_t b) {
                     const float at_a = positions[a][axis], at_b = positions[b][axis];
                     return at_a != at_b ? at_a < at_b : a < b;
                   });
  split(positions, order.first(left), piece);
  split(positions, order.subspan(left), piece);
}

}  // namespace

std::vector<std::uint32_t> compact_order(std::span<const Vec3> positions) {
  std::vector<std::uint32_t> order(positions.size());
  std::iota(order.begin(), order.end(), 0U);
  std::size_t piece = tree_width;
  while (piece < order.size()) piece *= tree_width;
  split(positions, order, piece);
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
