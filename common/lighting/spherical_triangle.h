/// A triangle seen from a point: its solid angle, and directions uniform within it.
#pragma once

#include <array>
#include <optional>

#include "common/core/vec.h"

namespace gibench {

/// In double precision: the triangle may be near, large and at a slant.
class SphericalTriangle {
 public:
  /// The corners relative to the point, metres.
  SphericalTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c);

  /// sr, in [0, 2π); 0 or NaN where the point lies in the triangle's plane or on a corner. Van Oosterom and Strackee 1983.
  double solid_angle() const { return solid_angle_; }
  /// Barycentrics of the second and third corner of the point seen in a uniform direction. Arvo 1995, "Stratified
  /// Sampling of Spherical Triangles". Empty where rounding leaves no direction.
  std::optional<Vec2> sample(Vec2 u) const;

 private:
  std::array<Vec3d, 3> corners_, units_;
  double solid_angle_ = 0.0;
};

}  // namespace gibench
