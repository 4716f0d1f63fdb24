/// The random numbers of one path, keyed by (seed, value, replicate, path, reflection, use).
#pragma once

#include <cstdint>

#include "common/core/sobol.h"
#include "common/lighting/light_group.h"

namespace gibench::pathtracer {

/// What a pair of numbers is for; those for light samples follow, two for each group of lights and sample.
enum class Use : std::uint32_t { direction, lobe_and_roulette, out, lobe_class, first_of_lights };
enum class LightUse : std::uint32_t { place, choice };

class PathRandom {
 public:
  PathRandom() : sequence_(0) {}
  PathRandom(std::uint64_t replicate_key, std::uint32_t index) : sequence_(replicate_key), index_(index) {}

  SobolPair pair(int reflection, Use use) const { return pair(reflection, static_cast<std::uint32_t>(use)); }
  SobolPair light_pair(int reflection, LightUse use, LightGroup group, std::uint32_t light_sample) const {
    const std::uint32_t way = light_sample * most_light_groups + static_cast<std::uint32_t>(group);
    return pair(reflection, static_cast<std::uint32_t>(Use::first_of_lights) + 2U * way + static_cast<std::uint32_t>(use));
  }

 private:
  static constexpr std::uint32_t pairs_per_vertex = 512;  // more than the uses and 64 samples of each group of lights take
  static constexpr int stratified_reflections = 6;        // deeper, many dimensions are mixed into each value

  SobolPair pair(int reflection, std::uint32_t use) const {
    const std::uint32_t dimension = static_cast<std::uint32_t>(reflection) * pairs_per_vertex + use;
    return reflection < stratified_reflections ? sequence_.pair(index_, dimension)
                                               : sequence_.independent_pair(index_, dimension);
  }

  SobolSequence sequence_;
  std::uint32_t index_ = 0;
};

}  // namespace gibench::pathtracer
