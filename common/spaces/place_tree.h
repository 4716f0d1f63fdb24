/// Binary trees over places, one for each label, halved in space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "common/spaces/place.h"

namespace gibench {

/// A run of places that lie together.
struct PlaceNode {
  Vec3 centre{0.0F};                 ///< of the box around its places
  float radius = 0.0F;               ///< metres: no place is further from the centre
  std::uint32_t begin = 0, end = 0;  ///< its places, in PlaceTree::order()
  float area = 0.0F;                 ///< m², of all its places
  std::uint32_t right = 0;           ///< the second child; the first is the next node; 0: a leaf, of one place

  bool is_leaf() const { return right == 0; }
};

/// Nodes in preorder. A box is halved across its longest side; where one half held less than an eighth of the places, they are
/// halved by count, so that the trees are O(log n) deep and made in O(n log n).
class PlaceTree {
 public:
  PlaceTree(std::span<const Place> places, Task& task);

  std::span<const PlaceNode> nodes() const { return nodes_; }
  /// One node for each label, by ascending label.
  std::span<const std::uint32_t> roots() const { return roots_; }
  /// Indices of the places by leaf, from left to right.
  std::span<const std::uint32_t> order() const { return order_; }
  /// Places looked at while it was made.
  std::uint64_t visits() const { return visits_; }

 private:
  struct Range {
    std::uint32_t node, begin, end;
    std::uint32_t size() const { return end - begin; }
  };
  std::vector<Range> label_ranges(std::span<const Place> places);
  /// Fills the node; the size of the left child, 0 of a leaf.
  std::uint32_t fill(std::span<const Place> places, const Range& range);
  std::uint64_t build_below(std::span<const Place> places, const Range& range);

  std::vector<PlaceNode> nodes_;
  std::vector<std::uint32_t> roots_, order_;
  std::uint64_t visits_ = 0;
};

}  // namespace gibench
