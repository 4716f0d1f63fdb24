/// The test whether a point lies inside geometry, by rays that hit the black backs of one-sided surfaces.
#pragma once

#include "common/ray/ray_stream.h"
#include "common/ray/world.h"

namespace gibench {

/// Whether a ray in this unit direction met the back of a one-sided surface.
inline bool meets_black_back(const World& world, const Hit& hit, const Vec3& direction) {
  return hit && !world.sample_of_hit(hit, direction).lit_side;
}

/// Whether each of the rays [begin, end) from a point just off a surface meets a black back; true of none. `direction_of(ray)`:
/// unit, in world space, asked in order for no more rays than it takes to know.
template <class DirectionOf>
bool all_meet_black_backs(const World& world, const Vec3& origin, int begin, int end, RayStream& rays,
                          const DirectionOf& direction_of) {
  for (int ray = begin; ray < end; ++ray) {
    const Vec3 direction = direction_of(ray);
    if (!meets_black_back(world, rays.closest_hit({origin, 0.0F, direction}), direction)) return false;
  }
  return true;
}

}  // namespace gibench
