/// Sight from one place of a surface to another over what stands between them, as high as a disc is wide.
#pragma once

#include <cstdint>

#include "common/core/vec.h"
#include "common/geometry/sampling_mesh.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"

namespace gibench::antiradiance {

/// A point over a place of a surface: as high as asked for, or half as high as the room above it. Detail that is lower does not
/// part two places; a wall that is higher does.
class Lookout {
 public:
  Lookout() = default;
  Lookout(const World& world, const SamplingMesh& mesh, std::uint32_t vertex, float height, RayStream& rays);
  /// Over a point off a surface, `normal` of length one.
  Lookout(const Vec3& origin, const Vec3& normal, float height, RayStream& rays);

  bool sees(const Lookout& other, RayStream& rays) const;

 private:
  void rise(const Vec3& origin, const Vec3& normal, float height, RayStream& rays);

  Vec3 at_{0.0F};
};

}  // namespace gibench::antiradiance
