/// Coefficients laid out for fast evaluation at many places: only the parts of each level that any coefficient
/// reaches, in blocks of eight basis functions whose weights are computed side by side.
#pragma once

#include <cstdint>
#include <vector>

#include "common/core/rgb.h"
#include "methods/meshless/box_tree.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/hierarchy.h"

namespace gibench::meshless {

class Expansion {
 public:
  explicit Expansion(const Coefficients& coefficients);

  /// The function at a place, all levels (Eq. 9).
  Rgb evaluate(const Place& at) const;

  /// The function at a place as a sender seen from `receiver`: coarse to fine, ending at the first level at which
  /// the balls of the basis functions that cover the place subtend less than `solid_angle` sr on average
  /// (section 6.3, GATHER). `levels_used` grows by the number of levels evaluated.
  Rgb evaluate_seen(const Place& at, const Vec3& receiver, float solid_angle, std::uint64_t& levels_used) const;

  std::size_t bytes() const;

 private:
  /// Eight basis functions; missing ones have an infinite inverse radius and never weigh.
  struct alignas(32) Block {
    float position[3][tree_width], normal[3][tree_width], inverse_radius_squared[tree_width];
    float red[tree_width], green[tree_width], blue[tree_width];
  };
  /// What a level contributes at one place, lane by lane.
  struct alignas(32) Sums {
    float weight[tree_width], red[tree_width], green[tree_width], blue[tree_width];
    float covering[tree_width], solid_angle[tree_width];
  };
  struct Cluster {
    std::vector<Block> blocks;
    BoxTree tree;
  };

  void add_cluster(const Coefficients& coefficients, std::uint32_t level, std::uint32_t group,
                   const std::vector<std::uint32_t>& points);
  static Block make_block(const Coefficients& coefficients, std::uint32_t begin, std::uint32_t end);
  static void add_weights(const Block& block, const Place& at, Sums& sums);
  static void add_solid_angles(const Block& block, const Place& at, const Vec3& receiver, Sums& sums);
  static bool level_value(const Sums& sums, Rgb& value);

  std::uint32_t levels_ = 0, groups_ = 0;
  std::vector<Cluster> clusters_;  ///< by level, then group
};

}  // namespace gibench::meshless
