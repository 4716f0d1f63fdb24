/// References whose truth is known: values with noise of a known size in every replicate.
#pragma once

#include <cmath>

#include "common/core/random.h"
#include "common/core/vec.h"
#include "common/metrics/replicas.h"

namespace gibench::test {

/// Standard normal number (Box and Muller).
inline float normal_number(RandomStream& random) {
  const double radius = std::sqrt(-2.0 * std::log(1.0 - random.next_double()));
  return static_cast<float>(radius * std::cos(2.0 * pi_double * random.next_double()));
}

/// truth + σ × normal noise, independent in every value, channel and replicate.
inline Replicas noisy_replicas(const std::vector<Rgb>& truth, std::size_t count, float sigma, std::uint64_t seed) {
  Replicas set;
  for (std::size_t r = 0; r < count; ++r) {
    RandomStream random(seed, 11, r);
    std::vector<Rgb>& replica = set.replicas.emplace_back(truth);
    for (Rgb& value : replica)
      for (int c = 0; c < 3; ++c) value[c] += sigma * normal_number(random);
  }
  return set;
}

/// truth × exponential noise of mean 1 and relative standard deviation `spread`, skewed as Monte Carlo estimates of few
/// bright paths are.
inline Replicas skewed_replicas(const std::vector<Rgb>& truth, std::size_t count, float spread, std::uint64_t seed) {
  Replicas set;
  for (std::size_t r = 0; r < count; ++r) {
    RandomStream random(seed, 12, r);
    std::vector<Rgb>& replica = set.replicas.emplace_back(truth);
    for (Rgb& value : replica)
      for (int c = 0; c < 3; ++c) value[c] *= 1.0F + spread * static_cast<float>(-std::log(1.0 - random.next_double()) - 1.0);
  }
  return set;
}

/// truth × (1 + noise of mean 0): one value in 500 is a firefly of fifty times the truth, on top of normal noise of this size.
inline Replicas replicas_with_fireflies(const std::vector<Rgb>& truth, std::size_t count, float sigma, std::uint64_t seed) {
  constexpr double rate = 0.002;
  constexpr float height = 50.0F;
  Replicas set = noisy_replicas(truth, count, sigma, seed);
  for (std::size_t r = 0; r < count; ++r) {
    RandomStream random(seed, 13, r);
    for (std::size_t i = 0; i < truth.size(); ++i) {
      const bool firefly = random.next_double() < rate;
      set.replicas[r][i] += truth[i] * (firefly ? height : -height * static_cast<float>(rate / (1.0 - rate)));
    }
  }
  return set;
}

}  // namespace gibench::test
