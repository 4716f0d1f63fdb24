#include "common/ray/coincident_rays.h"

namespace gibench {

void CoincidentRays::do_closest_hits(std::span<const Ray> rays, std::span<Hit> hits) const {
  rays_.closest_hits(rays, hits);
  for (std::size_t i = 0; i < hits.size(); ++i) hits[i] = faces_.in_front(hits[i], rays[i].direction);
}

void CoincidentRays::do_fan_hits(const RayFan& fan, const FanHits& hits) const {
  rays_.closest_hits(fan, hits);
  for (std::size_t i = 0; i < hits.triangle.size(); ++i) {
    const Hit hit = faces_.in_front({hits.triangle[i], hits.u[i], hits.v[i], 0.0F}, {fan.x[i], fan.y[i], fan.z[i]});
    hits.triangle[i] = hit.triangle, hits.u[i] = hit.u, hits.v[i] = hit.v;
  }
}

}  // namespace gibench
