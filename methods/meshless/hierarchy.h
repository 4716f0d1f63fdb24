/// The basis points of all levels and groups, their radii, and the search for the basis functions that cover a
/// point of the surfaces (Lehtinen et al. 2007, sections 4.1 and 4.2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "methods/meshless/box_tree.h"
#include "methods/meshless/packed_normal.h"
#include "methods/meshless/placement.h"
#include "methods/meshless/weights.h"

namespace gibench::meshless {

/// Where a function on the surfaces is asked for.
struct Place {
  Vec3 position{0.0F};
  Vec3 normal{0.0F};  ///< unit
  std::uint32_t group = 0;
};

/// A half-space that a basis function is confined to; by default all of space.
struct Cut {
  Vec3 normal{0.0F};
  float offset = -1.0F;  ///< of the plane along the normal, metres
  bool keeps(const Vec3& position) const { return glm::dot(normal, position) > offset; }
};
inline constexpr std::size_t cuts_of_a_function = 2;

class Hierarchy {
 public:
  Hierarchy() = default;
  /// Takes the placed points level by level, orders those of a level and group compactly, and gives each the
  /// distance to its k-th nearest neighbour as radius: among the points of its level and group that a weight could
  /// reach. No radius exceeds radius_limit disc radii of its level; a point with fewer than k neighbours so near gets that.
  Hierarchy(Placement placement, std::uint32_t groups, const Settings& settings, Task& task);

  std::uint32_t levels() const { return levels_; }
  std::uint32_t groups() const { return groups_; }
  /// Points are numbered across all levels, coarse to fine; within a level group by group.
  std::uint32_t size() const { return static_cast<std::uint32_t>(positions_.size()); }
  std::uint32_t level_begin(std::uint32_t level) const { return cluster_begin_[level * groups_]; }
  std::uint32_t level_size(std::uint32_t level) const { return level_begin(level + 1) - level_begin(level); }
  std::uint32_t level_of(std::uint32_t point) const;

  const Vec3& position(std::uint32_t point) const { return positions_[point]; }
  Vec3 normal(std::uint32_t point) const { return unpack_normal(normals_[point]); }
  float radius(std::uint32_t point) const { return radii_[point]; }
  std::uint32_t triangle(std::uint32_t point) const { return sides_[point] >> 1; }
  bool on_front(std::uint32_t point) const { return (sides_[point] & 1U) == 0; }
  std::uint32_t group_of(std::uint32_t point) const;
  Place place(std::uint32_t point) const { return {positions_[point], normal(point), group_of(point)}; }

  /// The run of points of one level and group.
  std::uint32_t cluster_begin(std::uint32_t level, std::uint32_t group) const { return cluster_begin_[level * groups_ + group]; }
  std::uint32_t cluster_end(std::uint32_t level, std::uint32_t group) const {
    return cluster_begin_[level * groups_ + group + 1];
  }
  /// Over blocks of eight consecutive points of that run; the boxes hold the balls.
  const BoxTree& tree(std::uint32_t level, std::uint32_t group) const { return trees_[level * groups_ + group]; }
  /// The box of the balls of one block.
  Box block_box(std::uint32_t level, std::uint32_t group, std::uint32_t block) const;

  /// Calls visit(point, weight) for every basis function of the level that is not zero at the place.
  template <class Visit>
  void visit_covering(std::uint32_t level, const Place& at, Visit&& visit) const {
    const bool cut = is_cut(level);
    visit_uncut(level, at, [&](std::uint32_t point, float w) {
      if (!cut || keeps(point, at.position)) visit(point, w);
    });
  }

  /// Likewise for every one that would not be zero there without its cuts.
  template <class Visit>
  void visit_uncut(std::uint32_t level, const Place& at, Visit&& visit) const {
    const std::uint32_t begin = cluster_begin(level, at.group), end = cluster_end(level, at.group);
    tree(level, at.group).visit_point(at.position, [&](std::uint32_t block) {
      const std::uint32_t last = std::min(end, begin + (block + 1) * tree_width);
      for (std::uint32_t point = begin + block * tree_width; point < last; ++point) {
        const Vec3 apart = at.position - positions_[point];
        const float distance_squared = glm::dot(apart, apart);
        if (!(distance_squared < radii_[point] * radii_[point])) continue;
        if (const float w = weight(distance_squared, radii_[point], glm::dot(at.normal, normal(point))); w > 0.0F)
          visit(point, w);
      }
    });
  }

  /// Whether any basis function is not zero at the place.
  bool covered(const Place& at) const {
    bool any = false;
    for (std::uint32_t level = 0; level < levels_ && !any; ++level)
      visit_covering(level, at, [&](std::uint32_t, float) { any = true; });
    return any;
  }

  /// The share of the surfaces' area that a point of level 0 stands for; all together 1. Even, unless it was set.
  double coarsest_share(std::uint32_t point) const {
    return coarsest_shares_.empty() ? 1.0 / static_cast<double>(level_size(0)) : coarsest_shares_[point];
  }
  void set_coarsest_shares(std::vector<double> shares) { coarsest_shares_ = std::move(shares); }

  /// Half-spaces for the functions of all levels from `first_level` on, cuts_of_a_function each. Without them none is cut.
  void set_cuts(std::uint32_t first_level, std::vector<Cut> cuts) {
    first_cut_ = level_begin(first_level);
    cuts_ = std::move(cuts);
  }
  bool is_cut(std::uint32_t level) const { return !cuts_.empty() && level_begin(level) >= first_cut_; }
  /// Of a point of a level that is cut.
  const Cut& cut(std::uint32_t point, std::size_t which) const {
    return cuts_[cuts_of_a_function * (point - first_cut_) + which];
  }

  std::size_t bytes() const;

 private:
  bool keeps(std::uint32_t point, const Vec3& position) const {
    for (std::size_t which = 0; which < cuts_of_a_function; ++which)
      if (!cut(point, which).keeps(position)) return false;
    return true;
  }
  void append(const std::vector<DiscPoint>& points);
  void find_radii(std::uint32_t level, std::uint32_t group, const Settings& settings, float disc_radius, Task& task);
  BoxTree make_tree(std::uint32_t level, std::uint32_t group) const;

  std::uint32_t levels_ = 0, groups_ = 0;
  std::vector<std::uint32_t> cluster_begin_;  ///< by level, then group; one more at the end
  std::vector<Vec3> positions_;
  std::vector<float> radii_;
  std::vector<std::uint32_t> normals_;  ///< packed
  std::vector<std::uint32_t> sides_;    ///< triangle · 2 + (1 on the back)
  std::vector<BoxTree> trees_;
  std::vector<double> coarsest_shares_;
  std::uint32_t first_cut_ = 0;  ///< point
  std::vector<Cut> cuts_;        ///< of all points from that one on
};

}  // namespace gibench::meshless
