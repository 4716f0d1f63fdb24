#include "common/lighting/triangle_emitter.h"

#include <algorithm>
#include <cmath>

#include "common/core/sampling.h"
#include "common/lighting/spherical_triangle.h"

namespace gibench {

namespace {

constexpr float near_radii = 2.5F;             // distances from the centre, in radii of the triangle
constexpr float edge_margin = 1e-6F;           // of the barycentrics: no ray slips through between two triangles
constexpr double smallest_solid_angle = 0.02;  // sr; a sliver of less is seen at a slant: by area

SphericalTriangle seen_from(const Vec3& from, const Vec3& corner, const Vec3& first, const Vec3& second) {
  const Vec3d relative = Vec3d(corner) - Vec3d(from);
  return {relative, relative + Vec3d(first), relative + Vec3d(second)};
}

}  // namespace

TriangleEmitter::TriangleEmitter(const World& world, std::uint32_t triangle, bool two_sided, const Rgb& radiance)
    : normal_(world.normal(triangle)),
      radiance_(radiance),
      area_(world.area(triangle)),
      triangle_(triangle),
      two_sided_(two_sided) {
  const Scene& scene = world.scene();
  const auto& corners = scene.triangles[triangle].corners;
  corner_ = scene.vertices[corners[0]];
  first_ = scene.vertices[corners[1]] - corner_;
  second_ = scene.vertices[corners[2]] - corner_;
  centre_ = corner_ + (first_ + second_) / 3.0F;
  offset_ = 0.0F;
  for (const std::uint32_t corner : corners) {
    const Vec3 position = scene.vertices[corner];
    radius_ = std::max(radius_, glm::distance(centre_, position));
    SurfaceSample at_corner;
    at_corner.position = position;
    at_corner.triangle = triangle;
    offset_ = std::max(offset_, world.offset(at_corner));
  }
  near_squared_ = near_radii * near_radii * radius_ * radius_;
  if (world.coincident().has_partners(triangle)) coincident_ = &world.coincident();
}

double TriangleEmitter::power() const {
  const double mean =
      (static_cast<double>(radiance_.r) + static_cast<double>(radiance_.g) + static_cast<double>(radiance_.b)) / 3.0;
  return (two_sided_ ? 2.0 : 1.0) * pi_double * static_cast<double>(area_) * mean;
}

/// Of two sides, |cos| is taken for its mean over all directions, a half.
PlacedLight TriangleEmitter::as_placed() const {
  const auto across = static_cast<float>(power() / ((two_sided_ ? 2.0 : 1.0) * pi_double));  // W/sr along the normal
  if (two_sided_) return {centre_, radius_, Vec3(0.0F), 0.5F * across};
  return {centre_, radius_, across * normal_, 0.0F};
}

/// The solid angle where the triangle is sampled by it, else 0.
double TriangleEmitter::near_solid_angle(const Vec3& from) const {
  const Vec3 apart = from - centre_;
  if (!(glm::dot(apart, apart) < near_squared_)) return 0.0;
  const double solid_angle = seen_from(from, corner_, first_, second_).solid_angle();
  return solid_angle > smallest_solid_angle ? solid_angle : 0.0;
}

/// Another triangle is met there.
bool TriangleEmitter::is_behind(Vec2 barycentrics, const Vec3& direction) const {
  return coincident_ != nullptr && !coincident_->shows(triangle_, barycentrics.x, barycentrics.y, direction);
}

LightSample TriangleEmitter::toward(const Vec3& from, Vec2 barycentrics) const {
  LightSample sample;
  const Vec3 point = corner_ + barycentrics.x * first_ + barycentrics.y * second_;
  const Vec3 way = point - from;
  const float squared = glm::dot(way, way);
  if (!(squared > 0.0F)) return sample;
  const float distance = std::sqrt(squared);
  sample.direction = way / distance;
  const float cosine = -glm::dot(normal_, sample.direction);
  if (cosine == 0.0F || (cosine < 0.0F && !two_sided_) || is_behind(barycentrics, sample.direction)) return sample;
  sample.radiance = radiance_;
  sample.target = point + (cosine > 0.0F ? offset_ : -offset_) * normal_;
  sample.pdf = squared / (std::fabs(cosine) * area_);
  return sample;
}

LightSample TriangleEmitter::sample(const Vec3& from, Vec2 u) const {
  const Vec3 apart = from - centre_;
  if (glm::dot(apart, apart) < near_squared_) {
    const SphericalTriangle seen = seen_from(from, corner_, first_, second_);
    if (seen.solid_angle() > smallest_solid_angle) {
      const std::optional<Vec2> barycentrics = seen.sample(u);
      if (!barycentrics) return {};
      LightSample sample = toward(from, *barycentrics);
      if (sample.pdf > 0.0F) sample.pdf = static_cast<float>(1.0 / seen.solid_angle());
      return sample;
    }
  }
  return toward(from, uniform_triangle(u));
}

/// Möller and Trumbore 1997.
Hit TriangleEmitter::met_by(const Vec3& origin, const Vec3& direction) const {
  const Vec3 across = glm::cross(direction, second_);
  const float determinant = glm::dot(first_, across);
  if (determinant == 0.0F) return {};
  const Vec3 apart = origin - corner_;
  const float u = glm::dot(apart, across) / determinant;
  if (!(u >= -edge_margin && u <= 1.0F + edge_margin)) return {};
  const Vec3 normal_to_both = glm::cross(apart, first_);
  const float v = glm::dot(direction, normal_to_both) / determinant;
  if (!(v >= -edge_margin && u + v <= 1.0F + edge_margin)) return {};
  const float distance = glm::dot(second_, normal_to_both) / determinant;
  return distance > 0.0F && !is_behind({u, v}, direction) ? Hit{triangle_, u, v, distance} : Hit{};
}

float TriangleEmitter::pdf(const Vec3& from, float distance, float cosine) const {
  if (const double solid_angle = near_solid_angle(from); solid_angle > 0.0) return static_cast<float>(1.0 / solid_angle);
  return cosine > 0.0F ? distance * distance / (cosine * area_) : 0.0F;
}

}  // namespace gibench
