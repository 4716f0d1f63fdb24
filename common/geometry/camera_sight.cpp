#include "common/geometry/camera_sight.h"

#include <array>

#include "common/core/sampling.h"
#include "common/core/vec.h"

namespace gibench {

namespace {

constexpr std::size_t reflection_rays = 16;

/// `rays`: a backend, or a counted tap on one.
template <class Rays>
bool is_seen(const SurfaceSample& sample, const World& world, const std::vector<CameraView>& views, Rays& rays) {
  for (const CameraView& view : views) {
    if (!view.in_picture(sample.position) || !(glm::dot(view.position - sample.position, sample.normal) > 0.0F)) continue;
    const Vec3 origin = world.ray_origin(sample);
    if (!rays.occluded({origin, 0.0F, view.position - origin, 1.0F})) return true;
  }
  return false;
}

}  // namespace

bool CameraSight::sees(const SurfaceSample& sample) const { return is_seen(sample, world_, views_, world_.rays()); }
bool CameraSight::sees(const SurfaceSample& sample, RayStream& rays) const { return is_seen(sample, world_, views_, rays); }

bool CameraSight::sees_reflection_to(const SurfaceSample& sample, RandomStream& random) const {
  std::array<Ray, reflection_rays> rays;
  std::array<Hit, reflection_rays> hits;
  const Frame frame(sample.normal);
  const Vec3 origin = world_.ray_origin(sample);
  for (Ray& ray : rays) {
    const float u = random.next_float(), v = random.next_float();
    ray = {origin, 0.0F, frame.to_world(cosine_hemisphere({u, v}))};
  }
  world_.rays().closest_hits(rays, hits);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!hits[i]) continue;
    const SurfaceSample reflector = world_.sample_of_hit(hits[i], rays[i].direction);
    if (reflector.lit_side && sees(reflector)) return true;
  }
  return false;
}

}  // namespace gibench
