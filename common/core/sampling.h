/// Maps from the unit square to discs, hemispheres and triangles.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/core/vec.h"

namespace gibench {

/// Area-preserving map to the unit disc that keeps neighbours together (Shirley and Chiu 1997).
inline Vec2 concentric_disc(Vec2 u) {
  const Vec2 centred = 2.0F * u - Vec2(1.0F);
  if (centred.x == 0.0F && centred.y == 0.0F) return Vec2(0.0F);
  const bool wide = std::fabs(centred.x) > std::fabs(centred.y);
  const float radius = wide ? centred.x : centred.y;
  const float angle = wide ? 0.25F * pi * (centred.y / centred.x) : 0.5F * pi - 0.25F * pi * (centred.x / centred.y);
  return radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Unit vector about +z with density cos θ / π.
inline Vec3 cosine_hemisphere(Vec2 u) {
  const Vec2 disc = concentric_disc(u);
  return {disc.x, disc.y, std::sqrt(std::max(0.0F, 1.0F - disc.x * disc.x - disc.y * disc.y))};
}
inline float cosine_hemisphere_pdf(float cosine) { return std::max(0.0F, cosine) * (1.0F / pi); }

/// Barycentrics of the second and third corner, uniform by area.
inline Vec2 uniform_triangle(Vec2 u) {
  const float root = std::sqrt(u.x);
  return {root * (1.0F - u.y), root * u.y};
}

}  // namespace gibench
