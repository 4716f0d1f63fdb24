#include "common/lighting/spherical_triangle.h"

#include <algorithm>
#include <cmath>

namespace gibench {

namespace {

double angle_between(const Vec3d& a, const Vec3d& b) { return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b)); }

/// The unit vector of `v` without its part along the unit vector `axis`.
Vec3d perpendicular(const Vec3d& v, const Vec3d& axis) { return glm::normalize(v - glm::dot(v, axis) * axis); }

double sine_of(double cosine) { return std::sqrt(std::max(0.0, 1.0 - cosine * cosine)); }

}  // namespace

SphericalTriangle::SphericalTriangle(const Vec3d& a, const Vec3d& b, const Vec3d& c)
    : corners_{a, b, c}, units_{glm::normalize(a), glm::normalize(b), glm::normalize(c)} {
  const auto& [ua, ub, uc] = units_;
  const double volume = std::fabs(glm::dot(ua, glm::cross(ub, uc)));
  solid_angle_ = 2.0 * std::atan2(volume, 1.0 + glm::dot(ua, ub) + glm::dot(ub, uc) + glm::dot(uc, ua));
}

std::optional<Vec2> SphericalTriangle::sample(Vec2 u) const {
  const auto& [a, b, c] = units_;
  const Vec3d side_ab = glm::cross(a, b), side_ca = glm::cross(c, a);
  // The angle at a, and the arc from a to b.
  const double alpha = angle_between(side_ab, -side_ca);
  const double cos_alpha = std::cos(alpha), sin_alpha = std::sin(alpha), cos_arc = glm::dot(a, b);
  // The angle at b of the subtriangle (a, b, c') of the share u.x of the solid angle is found from its excess
  // (Girard); from it the position of c' on the arc from a to c.
  const double excess_less_alpha = static_cast<double>(u.x) * solid_angle_ - alpha;
  const double s = std::sin(excess_less_alpha), t = std::cos(excess_less_alpha);
  const double p = t - cos_alpha, q = s + sin_alpha * cos_arc;
  const double denominator = (q * s + p * t) * sin_alpha;
  const double numerator = (q * t - p * s) * cos_alpha - q;
  const double cos_b = denominator != 0.0 ? std::clamp(numerator / denominator, -1.0, 1.0) : 1.0;
  const Vec3d moved = cos_b * a + sine_of(cos_b) * perpendicular(c, a);
  // A point on the arc from b to c', uniform in the cosine of its distance from b.
  const double cosine = 1.0 - static_cast<double>(u.y) * (1.0 - glm::dot(moved, b));
  const Vec3d direction = cosine * b + sine_of(cosine) * perpendicular(moved, b);

  const Vec3d first = corners_[1] - corners_[0], second = corners_[2] - corners_[0];
  const Vec3d slant = glm::cross(direction, second);
  const double determinant = glm::dot(first, slant);
  const Vec3d moment = glm::cross(-corners_[0], first);
  double x = glm::dot(-corners_[0], slant) / determinant;
  double y = glm::dot(direction, moment) / determinant;
  if (!std::isfinite(x) || !std::isfinite(y)) return std::nullopt;
  x = std::clamp(x, 0.0, 1.0);
  y = std::clamp(y, 0.0, 1.0 - x);
  return Vec2(static_cast<float>(x), static_cast<float>(y));
}

}  // namespace gibench
