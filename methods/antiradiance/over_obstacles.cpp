#include "methods/antiradiance/over_obstacles.h"

namespace gibench::antiradiance {

Lookout::Lookout(const World& world, const SamplingMesh& mesh, std::uint32_t vertex, float height, RayStream& rays) {
  const auto sites = mesh.sites(vertex);
  // Of several planes around a vertex the largest: its middle is furthest from what begins at an edge.
  const VertexSite* largest = sites.data();
  for (const VertexSite& site : sites)
    if (site.share > largest->share) largest = &site;
  const SurfaceSample sample = mesh.sample(world, vertex, *largest);
  rise(world.ray_origin(sample), mesh.vertices()[vertex].normal, height, rays);
}

Lookout::Lookout(const Vec3& origin, const Vec3& normal, float height, RayStream& rays) { rise(origin, normal, height, rays); }

void Lookout::rise(const Vec3& origin, const Vec3& normal, float height, RayStream& rays) {
  const Hit above = rays.closest_hit({origin, 0.0F, normal, 2.0F * height});
  at_ = origin + normal * (above ? 0.5F * above.distance : height);
}

bool Lookout::sees(const Lookout& other, RayStream& rays) const {
  const Vec3 way = other.at_ - at_;
  return !(glm::dot(way, way) > 0.0F) || !rays.occluded({at_, 0.0F, way, 1.0F});
}

}  // namespace gibench::antiradiance
