#include "methods/antiradiance/cell_point.h"

#include <glm/common.hpp>

namespace gibench::antiradiance {

namespace {

/// Barycentrics of the second and third corner of a point in the plane of a scene triangle.
Vec2 barycentrics_of(const Scene& scene, std::uint32_t triangle, const Vec3& point) {
  const auto& [i, j, k] = scene.triangles[triangle].corners;
  const Vec3d a = scene.vertices[i], b = Vec3d(scene.vertices[j]) - a, c = Vec3d(scene.vertices[k]) - a, p = Vec3d(point) - a;
  const double bb = glm::dot(b, b), bc = glm::dot(b, c), cc = glm::dot(c, c), pb = glm::dot(p, b), pc = glm::dot(p, c);
  const double determinant = bb * cc - bc * bc;
  if (!(determinant > 0.0)) return {0.0F, 0.0F};
  return {static_cast<float>((pb * cc - pc * bc) / determinant), static_cast<float>((pc * bb - pb * bc) / determinant)};
}

bool outside(const Vec2& at) { return at.x < -1e-4F || at.y < -1e-4F || at.x + at.y > 1.0F + 1e-4F; }

}  // namespace

SurfaceSample sample_of(const World& world, const CellPoint& point) {
  const Scene& scene = world.scene();
  SurfaceSample sample;
  sample.position = 0.5F * (point.origin + point.behind);
  sample.normal = point.normal;
  sample.triangle = point.triangle;
  sample.barycentrics = barycentrics_of(scene, sample.triangle, sample.position);
  const std::uint32_t next = sample.triangle + 1;
  if (outside(sample.barycentrics) && next < scene.triangles.size() &&
      scene.triangle_face[next] == scene.triangle_face[sample.triangle])
    sample.triangle = next, sample.barycentrics = barycentrics_of(scene, next, sample.position);
  sample.barycentrics = glm::clamp(sample.barycentrics, 0.0F, 1.0F);
  return sample;
}

}  // namespace gibench::antiradiance
