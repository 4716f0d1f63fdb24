/// The random numbers of one path, keyed by (seed, value, replicate, path, reflection, use).
#pragma once

#include <cstdint>

#include "common/core/sobol.h"

namespace gibench::pathtracer {

/// What a pair of numbers is for; light samples after the first take the pairs that follow.
enum class Use : std::uint32_t { direction, lobe_and_roulette, out, light_place, light_choice, lobe_class = 192 };

class PathRandom {
 public:
  PathRandom() : sequence_(0) {}
  PathRandom(std::uint64_t replicate_key, std::uint32_t index) : sequence_(replicate_key), index_(index) {}

  SobolPair pair(int reflection, Use use, std::uint32_t light_sample = 0) const {
    const std::uint32_t dimension =
        static_cast<std::uint32_t>(reflection) * pairs_per_vertex + static_cast<std::uint32_t>(use) + 2U * light_sample;
    return reflection < stratified_reflections ? sequence_.pair(index_, dimension)
                                               : sequence_.independent_pair(index_, dimension);
  }

 private:
  static constexpr std::uint32_t pairs_per_vertex = 256;  // more than the uses and 64 light samples take
  static constexpr int stratified_reflections = 6;        // deeper, many dimensions are mixed into each value

  SobolSequence sequence_;
  std::uint32_t index_ = 0;
};

}  // namespace gibench::pathtracer
