/// Coefficients laid out for fast evaluation at many places: only the parts of each level that any coefficient
/// reaches, in blocks of eight basis functions whose weights are computed side by side.
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

#include "common/core/lanes.h"
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

  /// Calls visit(position, normal) for every basis function of the finest level that adds to the function at the place.
  template <class Visit>
  void visit_finest(const Place& at, Visit&& visit) const;

  std::size_t bytes() const;

 private:
  /// Eight basis functions; missing ones have no normal and never weigh. Their coefficients stand apart, one Lanes per channel.
  struct Block {
    Lanes position[3], normal[3], inverse_radius_squared;
  };
  /// What a level contributes at one place, lane by lane.
  struct Sums {
    Lanes weight{}, colour[3]{};
    Lanes covering{}, solid_angle{};

    /// `values`: of the block, one Lanes per channel; a grey one stands for three.
    template <int channels>
    void add_weights(const Lanes* values, const Lanes& squared_ratio, const Lanes& cosine);
    void add_solid_angles(const Block& block, const Vec3& receiver, const Lanes& squared_ratio, const Lanes& cosine);
    /// Divides by the weights; false, and nothing to add, where none covers the place.
    template <int channels>
    bool level_value(Rgb& value) const;
  };
  struct Cluster {
    std::vector<Block> blocks;
    std::vector<Lanes> values;  ///< channels_ of every block
    std::vector<Lanes> cuts;    ///< where the level is cut: of every block, normal and offset of each half-space
    BoxTree tree;
  };

  void add_cluster(const Coefficients& coefficients, std::uint32_t level, std::uint32_t group,
                   const std::vector<std::uint32_t>& points);
  static void add_block(const Coefficients& coefficients, std::uint32_t begin, std::uint32_t end, Cluster& cluster);
  static void add_cuts(const Hierarchy& hierarchy, std::uint32_t begin, std::uint32_t end, Cluster& cluster);
  template <int channels>
  Rgb evaluate_channels(const Place& at) const;
  template <int channels>
  Rgb evaluate_channels_seen(const Place& at, const Vec3& receiver, float solid_angle, std::uint64_t& levels_used) const;
  static Lanes squared_ratio(const Block& block, const Vec3& position);
  /// Of the normals; 0 beyond a cut.
  static Lanes facing(const Cluster& cluster, std::uint32_t block, const Place& at);

  std::uint32_t levels_ = 0, groups_ = 0;
  /// Lanes of a block with a coefficient that is not zero.
  LaneMask counting(const Cluster& cluster, std::uint32_t block) const;

  int channels_ = 3;
  std::vector<Cluster> clusters_;  ///< by level, then group
};

template <class Visit>
void Expansion::visit_finest(const Place& at, Visit&& visit) const {
  bool found = false;
  for (std::uint32_t level = levels_; level-- > 0 && !found;) {
    const Cluster& cluster = clusters_[level * groups_ + at.group];
    cluster.tree.visit_point(at.position, [&](std::uint32_t index) {
      const Block& block = cluster.blocks[index];
      const LaneMask adds =
          (squared_ratio(block, at.position) < 1.0F) & (facing(cluster, index, at) > least_cosine) & counting(cluster, index);
      for (std::uint32_t bits = lane_bits(adds); bits != 0; bits &= bits - 1) {
        const auto i = static_cast<std::size_t>(std::countr_zero(bits));
        visit(Vec3(block.position[0][i], block.position[1][i], block.position[2][i]),
              Vec3(block.normal[0][i], block.normal[1][i], block.normal[2][i]));
        found = true;
      }
    });
  }
}

}  // namespace gibench::meshless
