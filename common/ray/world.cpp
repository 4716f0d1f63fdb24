#include "common/ray/world.h"

#include <utility>

#include "common/ray/coincident_rays.h"
#include "common/ray/embree/embree_backend.h"
#include "common/ray/ray_offset.h"

namespace gibench {

World::World(Scene scene, int threads) : World(std::move(scene), threads, make_embree_backend) {}

World::World(Scene scene, int threads, MakeRayBackend make_rays)
    : scene_(std::move(scene)),
      threads_(threads),
      make_rays_(std::move(make_rays)),
      geometry_(build_geometry()),
      coincident_(scene_, geometry_->normals(), geometry_->coplanar()) {
  settle();
}

World::World(Scene scene, const World& before)
    : scene_(std::move(scene)),
      threads_(before.threads_),
      make_rays_(before.make_rays_),
      geometry_(have_same_shape(scene_, before.scene_) ? before.geometry_ : build_geometry()),
      coincident_(scene_, geometry_->normals(), geometry_->coplanar()) {
  settle();
}

std::shared_ptr<const WorldGeometry> World::build_geometry() const {
  return std::make_shared<const WorldGeometry>(scene_, make_rays_(scene_.vertices, scene_.triangles, threads_), threads_);
}

void World::settle() {
  if (!coincident_.empty()) settled_rays_ = std::make_unique<const CoincidentRays>(geometry_->rays(), coincident_);
  total_area_ = geometry_->total_area();
  for (std::uint32_t triangle = 0; triangle < scene_.triangles.size(); ++triangle)
    if (coincident_.is_hidden(triangle)) total_area_ -= static_cast<double>(geometry_->area(triangle));
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
  return ray_offset(max_abs(sample.position), geometry_->extent(sample.triangle));
}

Ray World::segment(const SurfaceSample& from, const SurfaceSample& to) const {
  const Vec3 origin = ray_origin(from);
  return {origin, 0.0F, ray_origin(to) - origin, 1.0F};
}

}  // namespace gibench
