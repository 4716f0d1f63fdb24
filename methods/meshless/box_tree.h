/// An implicit eight-way tree of boxes over leaves in a given order: no pointers, eight boxes tested at once.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "common/core/lanes.h"
#include "common/core/vec.h"

namespace gibench::meshless {

inline constexpr std::uint32_t tree_width = lane_count;  ///< children of a node, and points of a leaf block

struct Box {
  Vec3 low{std::numeric_limits<float>::infinity()};
  Vec3 high{-std::numeric_limits<float>::infinity()};

  void add(const Vec3& centre, float radius) {
    low = glm::min(low, centre - radius);
    high = glm::max(high, centre + radius);
  }
  void add(const Box& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
};

/// An order of the points in which every run of 8, 64, 512, … starting at a multiple of its length is compact:
/// recursive median splits across the longest side. Ties are settled by the point's number.
std::vector<std::uint32_t> compact_order(std::span<const Vec3> positions);

class BoxTree {
 public:
  BoxTree() = default;
  explicit BoxTree(std::span<const Box> leaves);

  bool empty() const { return nodes_.empty(); }
  std::size_t bytes() const { return nodes_.capacity() * sizeof(Node); }

  /// Calls visit(leaf number) for every leaf whose box holds the point, in a fixed order.
  template <class Visit>
  void visit_point(const Vec3& point, Visit&& visit) const {
    traverse([&](const Node& node) { return node.holding(point); }, visit);
  }
  /// The same for every leaf whose box meets the cube of this half edge around the point.
  template <class Visit>
  void visit_cube(const Vec3& centre, float half_edge, Visit&& visit) const {
    traverse([&](const Node& node) { return node.meeting(centre - half_edge, centre + half_edge); }, visit);
  }
  /// The same nearest child first, for every leaf nearer to the point than √limit(), which may shrink on the way.
  template <class Limit, class Visit>
  void visit_nearest(const Vec3& point, Limit&& limit, Visit&& visit) const {
    if (!nodes_.empty()) descend(point, static_cast<std::uint32_t>(first_node_.size() - 1), 0, limit, visit);
  }

 private:
  /// Eight boxes side by side; missing ones are empty.
  struct Node {
    Lanes low[3], high[3];

    std::uint32_t holding(const Vec3& p) const { return meeting(p, p); }
    /// Bit i is set where box i takes part.
    std::uint32_t meeting(const Vec3& from, const Vec3& to) const {
      return lane_bits((low[0] <= to.x) & (high[0] >= from.x) & (low[1] <= to.y) & (high[1] >= from.y) & (low[2] <= to.z) &
                       (high[2] >= from.z));
    }
    /// Squared distance of a point to each box.
    Lanes distance_squared(const Vec3& p) const {
      Lanes sum{};
      for (int axis = 0; axis < 3; ++axis) {
        const Lanes gap = larger(Lanes{}, larger(p[axis] - high[axis], low[axis] - p[axis]));
        sum += gap * gap;
      }
      return sum;
    }
  };
  struct Entry {
    std::uint32_t height, node;
  };

  template <class Test, class Visit>
  void traverse(Test&& test, Visit&& visit) const {
    if (nodes_.empty()) return;
    Entry stack[tree_width * 12];
    std::uint32_t size = 0;
    stack[size++] = {static_cast<std::uint32_t>(first_node_.size() - 1), 0};
    while (size > 0) {
      const Entry at = stack[--size];
      for (std::uint32_t mask = test(nodes_[first_node_[at.height] + at.node]); mask != 0; mask &= mask - 1) {
        const std::uint32_t child = at.node * tree_width + static_cast<std::uint32_t>(std::countr_zero(mask));
        if (at.height == 0) visit(child);
        else stack[size++] = {at.height - 1, child};
      }
    }
  }

  template <class Limit, class Visit>
  void descend(const Vec3& point, std::uint32_t height, std::uint32_t index, Limit&& limit, Visit&& visit) const;

  std::vector<Node> nodes_;                ///< height by height, leaves' parents first
  std::vector<std::uint32_t> first_node_;  ///< of each height
};

template <class Limit, class Visit>
void BoxTree::descend(const Vec3& point, std::uint32_t height, std::uint32_t index, Limit&& limit, Visit&& visit) const {
  const Node& node = nodes_[first_node_[height] + index];
  Lanes distance_squared = node.distance_squared(point);
  for (std::uint32_t turn = 0; turn < tree_width; ++turn) {
    std::uint32_t nearest = 0;
    for (std::uint32_t i = 1; i < tree_width; ++i)
      if (distance_squared[i] < distance_squared[nearest]) nearest = i;
    if (!(distance_squared[nearest] < limit())) return;
    distance_squared[nearest] = std::numeric_limits<float>::infinity();
    const std::uint32_t child = index * tree_width + nearest;
    if (height == 0) visit(child);
    else descend(point, height - 1, child, limit, visit);
  }
}

}  // namespace gibench::meshless
