/// Unit square to directions, and the weights that combine samplers.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/core/vec.h"

namespace gibench {

/// Concentric map of the unit square to the unit disc (Shirley and Chiu 1997).
inline Vec2 square_to_disc(Vec2 u) {
  const float a = 2.0F * u.x - 1.0F;
  const float b = 2.0F * u.y - 1.0F;
  if (a == 0.0F && b == 0.0F) return {0.0F, 0.0F};
  const bool a_larger = std::fabs(a) > std::fabs(b);
  const float radius = a_larger ? a : b;
  const float angle = a_larger ? (pi / 4.0F) * (b / a) : (pi / 2.0F) - (pi / 4.0F) * (a / b);
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

/// Direction about +z with density cos θ / π.
inline Vec3 square_to_cosine_hemisphere(Vec2 u) {
  const Vec2 disc = square_to_disc(u);
  const float squared = disc.x * disc.x + disc.y * disc.y;
  return {disc.x, disc.y, std::sqrt(std::max(0.0F, 1.0F - squared))};
}

/// Power heuristic with exponent 2 (Veach 1997, 9.2.4), safe for infinite and zero densities.
inline float power_heuristic(float own_pdf, float other_pdf) {
  if (!(own_pdf > 0.0F)) return 0.0F;
  const float ratio = other_pdf / own_pdf;
  return 1.0F / (1.0F + ratio * ratio);
}

}  // namespace gibench
