/// A point on one side of a triangle, as rays start from it and as the other parts of the project see it.
#pragma once

#include "common/core/vec.h"
#include "common/ray/world.h"

namespace gibench {

inline SurfaceSample surface_sample(const World& world, std::uint32_t triangle, const Vec3& position, const Vec3& normal) {
  SurfaceSample sample;
  sample.position = position;
  sample.normal = normal;
  sample.triangle = triangle;
  sample.object = world.scene().triangle_object[triangle];
  sample.face = world.scene().triangle_face[triangle];
  return sample;
}

}  // namespace gibench
