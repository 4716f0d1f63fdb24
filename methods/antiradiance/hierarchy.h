/// The hierarchy of discs: binary trees over the elements of all objects, built in O(n log n) on all threads.
#pragma once

#include <compare>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/method/task.h"
#include "methods/antiradiance/elements.h"

namespace gibench::antiradiance {

inline constexpr std::uint32_t several_sheets = 0xffffffffU;

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
  std::uint32_t sheet = 0;           ///< of its elements; several_sheets where they are of more than one
  bool black_back = true;            ///< see Elements::black_back(); a tree's elements are all alike
  bool is_leaf() const { return right == 0; }
  std::uint32_t tree_size() const { return 2 * (end - begin) - 1; }  ///< nodes from here down
  Disc disc() const { return {centre, normal, area}; }
};

/// Nodes in preorder: a node's subtree is a run, children come after parents. Each space has three trees at most, whatever the
/// number of objects: of one-sided surfaces, and of the fronts and the backs of two-sided ones (unless sheets are kept apart).
class Hierarchy {
 public:
  Hierarchy() = default;
  /// Over the elements that are exposed at all. A node is split in space or by its normals, whichever spread more.
  /// `spaces`: of every element; each has trees of its own (empty: all are in one).
  /// `sheets_apart`: every sheet has a tree of its own, which receivers then start with, one by one.
  Hierarchy(const Elements& elements, std::span<const std::uint32_t> spaces, Task& task, bool sheets_apart = false);

  std::span<const Node> nodes() const { return nodes_; }
  std::size_t size() const { return nodes_.size(); }
  std::span<const std::uint32_t> roots() const { return roots_; }
  /// The roots whose space is that of this root, by its place among roots().
  std::span<const std::uint32_t> roots_beside(std::size_t root) const;
  /// Whether a tree, by its place among roots(), is of the backs of two-sided surfaces, whose fronts have another.
  bool is_of_backs(std::size_t root) const { return root_kinds_[root] == Kind::back; }
  /// Elements by leaf, from left to right.
  std::span<const std::uint32_t> order() const { return order_; }
  std::size_t leaf_count() const { return order_.size(); }
  std::uint32_t leaf_node(std::size_t leaf) const { return leaf_nodes_[leaf]; }
  std::uint32_t element(const Node& leaf) const { return order_[leaf.begin]; }
  /// A leaf below a node, drawn in proportion to its area; `u` in [0, 1).
  const Node& leaf_by_area(std::uint32_t node, float u) const;
  /// Leaf of an element; no_element where it takes no part.
  std::uint32_t leaf_of_element(std::uint32_t element) const { return leaf_of_element_[element]; }

  std::size_t bytes() const;

 private:
  enum class Kind : std::uint8_t { one_sided, front, back };
  static Kind kind_of(const Elements& elements, std::uint32_t element);
  /// What the elements of one tree have in common.
  struct TreeKey {
    std::uint32_t space;
    Kind kind;
    std::uint32_t sheet;
    auto operator<=>(const TreeKey&) const = default;
  };
  struct Range {
    std::uint32_t node, begin, end;
  };
  std::vector<std::vector<std::uint32_t>> split_all(const Elements& elements, const std::function<TreeKey(std::uint32_t)>& key,
                                                    Task& task);
  std::uint32_t split(const Elements& elements, const Range& range);
  void fill(const Elements& elements, std::uint32_t index);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> roots_, root_spaces_, order_, leaf_nodes_, leaf_of_element_;
  std::vector<Kind> root_kinds_;
};

/// Visits the nodes of a tree in preorder: what is below an inner node only where opens(its number) is true.
template <class Opens>
void visit_down(std::span<const Node> nodes, std::uint32_t root, const Opens& opens) {
  const std::uint32_t end = root + nodes[root].tree_size();
  for (std::uint32_t node = root; node < end;) node += opens(node) ? 1U : nodes[node].tree_size();
}

}  // namespace gibench::antiradiance
