#include "common/ray/world.h"

#include <algorithm>
#include <utility>

#include "common/ray/embree/embree_backend.h"

namespace gibench {

namespace {

// A position is rounded relative to its coordinates, Embree's intersection relative to the triangle's extent. Of four
// million rays from each of four tilted and moved rooms, 2^-22 of both was the least at which none met its own triangle
// again; four and two times that leave room, and let walls of a millimetre stand in scenes of a kilometre.
constexpr float offset_per_coordinate = 0x1p-20F;
constexpr float offset_per_extent = 0x1p-21F;

}  // namespace

World::World(Scene scene, int threads) : World(std::move(scene), threads, make_embree_backend) {}

World::World(Scene scene, int threads, const MakeRayBackend& make_rays)
    : scene_(std::move(scene)), rays_(make_rays(scene_.vertices, scene_.triangles, threads)) {
  const std::size_t count = scene_.triangles.size();
  normals_.resize(count);
  areas_.resize(count);
  extents_.resize(count);
  if (!scene_.vertices.empty()) bounds_min_ = bounds_max_ = scene_.vertices.front();
  for (const Vec3& v : scene_.vertices) bounds_min_ = glm::min(bounds_min_, v), bounds_max_ = glm::max(bounds_max_, v);
  for (std::size_t i = 0; i < count; ++i) {
    const auto& [a, b, c] = scene_.triangles[i].corners;
    const Vec3d first = Vec3d(scene_.vertices[b]) - Vec3d(scene_.vertices[a]);
    const Vec3d second = Vec3d(scene_.vertices[c]) - Vec3d(scene_.vertices[a]);
    const Vec3d doubled = glm::cross(first, second);
    const double length = glm::length(doubled);
    areas_[i] = static_cast<float>(0.5 * length);
    normals_[i] = areas_[i] > 0.0F ? Vec3(doubled / length) : Vec3(0.0F);
    extents_[i] = std::max(max_abs(Vec3(first)), max_abs(Vec3(second)));
    total_area_ += 0.5 * length;
  }
}

Vec3 World::position(std::uint32_t triangle, Vec2 barycentrics) const {
  const auto& [a, b, c] = scene_.triangles[triangle].corners;
  const Vec3 &pa = scene_.vertices[a], &pb = scene_.vertices[b], &pc = scene_.vertices[c];
  return pa + barycentrics.x * (pb - pa) + barycentrics.y * (pc - pa);
}

SurfaceSample World::sample_at(std::uint32_t triangle, Vec2 barycentrics, const Vec3& seen_from_direction) const {
  SurfaceSample sample;
  sample.position = position(triangle, barycentrics);
  const bool front = glm::dot(normals_[triangle], seen_from_direction) >= 0.0F;
  sample.normal = front ? normals_[triangle] : -normals_[triangle];
  sample.object = scene_.triangle_object[triangle];
  sample.face = scene_.triangle_face[triangle];
  sample.triangle = triangle;
  sample.barycentrics = barycentrics;
  sample.lit_side = front || scene_.objects[sample.object].two_sided;
  return sample;
}

float World::offset(const SurfaceSample& sample) const {
  return offset_per_coordinate * max_abs(sample.position) + offset_per_extent * extents_[sample.triangle];
}

Ray World::segment(const SurfaceSample& from, const SurfaceSample& to) const {
  const Vec3 origin = ray_origin(from);
  return {origin, 0.0F, ray_origin(to) - origin, 1.0F};
}

}  // namespace gibench
