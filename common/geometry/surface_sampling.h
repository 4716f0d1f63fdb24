/// The surface samples on which every method is compared: uniform by area over all lit sides, independent of
/// any view.
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "common/core/random.h"
#include "common/ray/world.h"

namespace gibench {

/// `count` samples, stratified by area over all sides that light can leave (both sides of two-sided objects);
/// degenerate triangles get none, and coincident ones only where they are in front. The same seed gives the same samples. Empty
/// where the scene has no area.
std::vector<SurfaceSample> area_uniform_samples(const World& world, std::size_t count, std::uint64_t seed);

/// The part of a scene that is sampled; an empty function keeps everything.
struct SampledPart {
  std::function<bool(std::uint32_t object)> keeps_object;
  std::function<bool(std::uint32_t triangle, bool front)> keeps_side;
  /// Whether anything in the box may be kept: triangles are cut into pieces of `piece_size` metres, and the others left out, so
  /// that a part of a large plane is found.
  std::function<bool(const Vec3& low, const Vec3& high)> may_keep_in;
  float piece_size = 0.0F;
  std::function<bool(const SurfaceSample& sample, RandomStream& random)> keeps;  ///< called by several threads at once
};
/// The same over a part of the scene; fewer where a thousand draws met nothing of it. Any number of threads (0: all cores) gives
/// the same samples.
std::vector<SurfaceSample> area_uniform_samples(const World& world, const SampledPart& part, std::size_t count,
                                                std::uint64_t seed, int threads = 0);

}  // namespace gibench
