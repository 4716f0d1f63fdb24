#include "common/ray/world.h"

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

World::World(Scene scene, int threads, MakeRayBackend make_rays)
    : scene_(std::move(scene)), threads_(threads), make_rays_(std::move(make_rays)) {
  build_geometry();
}

World::World(Scene scene, const World& before)
    : scene_(std::move(scene)), threads_(before.threads_), make_rays_(before.make_rays_) {
  if (have_same_shape(scene_, before.scene_)) geometry_ = before.geometry_;
  else build_geometry();
}

void World::build_geometry() {
  geometry_ = std::make_shared<const WorldGeometry>(scene_, make_rays_(scene_.vertices, scene_.triangles, threads_));
}

Vec3 World::position(std::uint32_t triangle, Vec2 barycentrics) const {
  const auto& [a, b, c] = scene_.triangles[triangle].corners;
  const Vec3 &pa = scene_.vertices[a], &pb = scene_.vertices[b], &pc = scene_.vertices[c];
  return pa + barycentrics.x * (pb - pa) + barycentrics.y * (pc - pa);
}

SurfaceSample World::sample_at(std::uint32_t triangle, Vec2 barycentrics, const Vec3& seen_from_direction) const {
  SurfaceSample sample;
  sample.position = position(triangle, barycentrics);
  const Vec3& face_normal = normal(triangle);
  const bool front = glm::dot(face_normal, seen_from_direction) >= 0.0F;
  sample.normal = front ? face_normal : -face_normal;
  sample.object = scene_.triangle_object[triangle];
  sample.face = scene_.triangle_face[triangle];
  sample.triangle = triangle;
  sample.barycentrics = barycentrics;
  sample.lit_side = front || scene_.objects[sample.object].two_sided;
  return sample;
}

float World::offset(const SurfaceSample& sample) const {
  return offset_per_coordinate * max_abs(sample.position) + offset_per_extent * geometry_->extent(sample.triangle);
}

Ray World::segment(const SurfaceSample& from, const SurfaceSample& to) const {
  const Vec3 origin = ray_origin(from);
  return {origin, 0.0F, ray_origin(to) - origin, 1.0F};
}

}  // namespace gibench
