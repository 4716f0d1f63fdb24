/// Hierarchical Poisson-disc distributions on surfaces (Lehtinen et al. 2007, section 6.1): points no two of
/// which are nearer than a radius, and so many that hardly another fits.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/ray/world.h"

namespace gibench {

/// One side of one triangle.
struct SurfaceSide {
  std::uint32_t triangle = 0;
  bool front = true;
};

/// A point of the distribution.
struct DiscPoint {
  Vec3 position{0.0F};
  Vec3 normal{0.0F};  ///< unit, on the side the point lies on
  SurfaceSide side;
};

/// Whether each point of a batch may be a sample at all (the backface test, for one); 1 keeps it. A point that
/// is turned down counts as a failed proposal. May be called from the calling thread only.
using PointTest = std::function<void(std::span<const DiscPoint>, std::span<std::uint8_t> keep)>;

/// How points are proposed and tested, and when a level ends.
struct PoissonDiscOptions {
  std::uint64_t seed = 1;
  int threads = 0;                  ///< 0: all cores
  int failures = 1000;              ///< proposals turned down in a row that end a level
  PointTest test;                   ///< empty: every point may be a sample
  std::function<bool()> cancelled;  ///< asked between batches; empty: never
};

/// Throws darts, area-uniform over the given sides, level after level. A dart is kept where every sample q of
/// this and all coarser levels is at least radius · max(0, n·n_q) away, so that over a corner of 90° or more two
/// samples may be as near as they like. Darts are tested in batches on all threads and conflicts inside a batch
/// settled in the order of their numbers: the outcome is that of throwing them one by one, for any number of threads.
class PoissonDisc {
 public:
  /// Sides of zero area are left out. The world must outlive this object.
  PoissonDisc(const World& world, std::vector<SurfaceSide> sides, PoissonDiscOptions options);

  /// The samples of the next level, in the order in which they were kept; none where there is no area.
  std::vector<DiscPoint> add_level(float radius);

  double area() const { return area_; }  ///< m², of all sides
  std::uint64_t proposals() const { return proposals_; }

 private:
  struct Grid;
  struct AliasEntry {
    float threshold;
    std::uint32_t other;
  };

  void build_alias_table();
  DiscPoint propose(std::uint64_t number) const;
  void test_batch(std::vector<DiscPoint>& darts, std::vector<std::uint8_t>& alive, const Grid& grid) const;

  const World& world_;
  std::vector<SurfaceSide> sides_;
  std::vector<AliasEntry> alias_;
  PoissonDiscOptions options_;
  double area_ = 0.0;
  std::vector<DiscPoint> kept_;  ///< of all levels
  std::uint64_t proposals_ = 0;
};

/// Every side that light can leave of the objects for which `wanted` is not 0 (one entry per object).
std::vector<SurfaceSide> lit_sides(const World& world, std::span<const std::uint8_t> wanted);

}  // namespace gibench
