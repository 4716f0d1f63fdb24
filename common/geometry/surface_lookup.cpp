#include "common/geometry/surface_lookup.h"

#include <cmath>
#include <limits>

namespace gibench {

namespace {

constexpr float least_agreement = 0.5F;  // cosine of 60 degrees: a tessellated sphere asked about with its own normals
constexpr float distance_weight = 1e-3F;
constexpr float back_penalty = 4.0F;  // more than any angle and distance

/// Barycentrics (of the second and third corner) of the point of a triangle nearest to `point` (Ericson, Real-Time
/// Collision Detection, 5.1.5).
Vec2 nearest_barycentrics(const Vec3& point, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3d ab = Vec3d(b) - Vec3d(a), ac = Vec3d(c) - Vec3d(a);
  const Vec3d ap = Vec3d(point) - Vec3d(a), bp = Vec3d(point) - Vec3d(b), cp = Vec3d(point) - Vec3d(c);
  const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {0.0F, 0.0F};
  const double d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp);
  if (d3 >= 0.0 && d4 <= d3) return {1.0F, 0.0F};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {static_cast<float>(d1 / (d1 - d3)), 0.0F};
  const double d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
  if (d6 >= 0.0 && d5 <= d6) return {0.0F, 1.0F};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {0.0F, static_cast<float>(d2 / (d2 - d6))};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {static_cast<float>(1.0 - w), static_cast<float>(w)};
  }
  const double sum = va + vb + vc;
  return {static_cast<float>(vb / sum), static_cast<float>(vc / sum)};
}

/// The sample of what is in front where triangles coincide.
SurfaceSample settled(const World& world, const SurfaceSample& sample) {
  const Hit found{sample.triangle, sample.barycentrics.x, sample.barycentrics.y, 0.0F};
  const Hit hit = world.coincident().in_front(found, -sample.normal);
  return hit.triangle == sample.triangle ? sample : world.sample_at(hit.triangle, {hit.u, hit.v}, sample.normal);
}

}  // namespace

std::optional<SurfaceSample> find_surface_point(const World& world, const Vec3& point, const Vec3& normal, float max_distance) {
  const Scene& scene = world.scene();
  std::optional<SurfaceSample> best;
  float best_score = std::numeric_limits<float>::infinity();
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    const float cosine = glm::dot(world.normal(t), normal);
    if (!(world.area(t) > 0.0F) || std::fabs(cosine) < least_agreement) continue;
    const auto& [a, b, c] = scene.triangles[t].corners;
    if (std::fabs(glm::dot(world.normal(t), point - scene.vertices[a])) > max_distance) continue;
    const Vec2 nearest = nearest_barycentrics(point, scene.vertices[a], scene.vertices[b], scene.vertices[c]);
    const float distance = glm::length(world.position(t, nearest) - point);
    if (distance > max_distance) continue;
    const float score =
        (1.0F - std::fabs(cosine)) + distance_weight * distance / max_distance + (cosine < 0.0F ? back_penalty : 0.0F);
    if (score >= best_score) continue;
    best_score = score;
    best = world.sample_at(t, nearest, normal);
  }
  return best ? settled(world, *best) : best;
}

}  // namespace gibench
