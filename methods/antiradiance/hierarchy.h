/// The hierarchy of discs: a binary tree for every object (for each side of a two-sided one), its leaves the elements, built in
/// O(n log n) on all threads.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/antiradiance/elements.h"

namespace gibench::antiradiance {

/// A disc that stands for a run of elements. 64 bytes: one line of the cache.
struct alignas(64) Node {
  Vec3 centre{0.0F};        ///< area-weighted mean of the elements' centres
  float reach = 0.0F;       ///< metres: no element's centre is further from the node's
  Vec3 normal{0.0F};        ///< unit; area-weighted mean
  float area = 0.0F;        ///< m²
  float thickness = 0.0F;   ///< metres: no element's centre is further from the disc's plane
  float cone_sine = 0.0F;   ///< of the half-angle about `normal` that holds all elements' normals; 1 from a right angle on
  std::uint32_t right = 0;  ///< the second child; the first is the next node; 0: a leaf
  std::uint32_t begin = 0, end = 0;  ///< its elements, in Hierarchy::order()
  bool black_back = true;            ///< see Elements::black_back(); one object's elements are all alike
  bool is_leaf() const { return right == 0; }
  Disc disc() const { return {centre, normal, area}; }
};

/// Nodes in preorder: a node's subtree is a run, children come after parents.
class Hierarchy {
 public:
  Hierarchy() = default;
  /// Over the elements that are exposed at all. A node is split in space or by its normals, whichever spread more.
  /// `spaces`: of every element; each has trees of its own (empty: all are in one).
  Hierarchy(const Elements& elements, std::span<const std::uint32_t> spaces, Task& task);

  std::span<const Node> nodes() const { return nodes_; }
  std::size_t size() const { return nodes_.size(); }
  std::span<const std::uint32_t> roots() const { return roots_; }
  /// The roots whose space is that of this root.
  std::vector<std::uint32_t> roots_beside(std::size_t root) const;
  /// Elements by leaf, from left to right.
  std::span<const std::uint32_t> order() const { return order_; }
  std::size_t leaf_count() const { return order_.size(); }
  std::uint32_t leaf_node(std::size_t leaf) const { return leaf_nodes_[leaf]; }
  std::uint32_t element(const Node& leaf) const { return order_[leaf.begin]; }
  /// Leaf of an element; no_element where it takes no part.
  std::uint32_t leaf_of_element(std::uint32_t element) const { return leaf_of_element_[element]; }

  std::size_t bytes() const;

 private:
  struct Range {
    std::uint32_t node, begin, end;
  };
  std::vector<std::vector<std::uint32_t>> split_all(const Elements& elements, std::span<const std::uint32_t> spaces, Task& task);
  std::uint32_t split(const Elements& elements, const Range& range);
  void fill(const Elements& elements, std::uint32_t index);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_, root_spaces_, order_, leaf_nodes_, leaf_of_element_;
};

}  // namespace gibench::antiradiance
