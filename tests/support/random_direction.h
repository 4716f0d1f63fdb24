/// Unit vectors at random, uniform over the sphere.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/core/random.h"
#include "common/core/vec.h"

namespace gibench::test {

/// Number `index` of the series `stage`.
inline Vec3 random_direction(std::uint64_t stage, std::uint64_t index) {
  RandomStream random(3, stage, index);
  const float z = 2.0F * random.next_float() - 1.0F, angle = 2.0F * pi * random.next_float();
  const float radius = std::sqrt(std::max(0.0F, 1.0F - z * z));
  return {radius * std::cos(angle), radius * std::sin(angle), z};
}

}  // namespace gibench::test
