/// The weight of a basis point at a surface point (Lehtinen et al. 2007, Eq. 12 and 13).
#pragma once

#include <algorithm>
#include <cmath>

#include "common/core/vec.h"

namespace gibench::meshless {

/// Normals whose cosine is not above this see nothing of each other. The paper's bound is 0; above rounding,
/// walls that meet at exactly 90° do not leak into each other in a turned scene either.
inline constexpr float least_cosine = 1e-3F;

/// K of Eq. 13 by the square of its argument, which must be in [0, 1].
inline float kernel(float squared_ratio) { return squared_ratio * (2.0F * std::sqrt(squared_ratio) - 3.0F) + 1.0F; }

/// Eq. 12; 0 outside the ball and for points that face away.
inline float weight(float distance_squared, float radius, float cosine) {
  const float squared_ratio = distance_squared / (radius * radius);
  if (!(squared_ratio < 1.0F) || !(cosine > least_cosine)) return 0.0F;
  return kernel(squared_ratio) * cosine;
}

}  // namespace gibench::meshless
