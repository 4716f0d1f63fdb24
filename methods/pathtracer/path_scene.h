/// The scene as the inner loop wants it: all that a hit needs in one cache line.
#pragma once

#include <cstdint>
#include <vector>

#include "common/core/prefetch.h"
#include "common/ray/world.h"
#include "common/reflectance/bsdf.h"

namespace gibench::pathtracer {

struct alignas(64) PathTriangle {
  Vec3 corner, first, second;  ///< a corner and the two edges from it, metres
  Vec3 normal;                 ///< of the front, unit
  float extent;                ///< of rays that leave, as World::offset() takes it
  std::uint32_t material;
  std::uint32_t two_sided;

  Vec3 position(const Hit& hit) const { return corner + hit.u * first + hit.v * second; }
};

/// Geometry and materials; the lights are apart.
struct PathScene {
  explicit PathScene(const World& world);

  void prefetch_triangle(const Hit& hit) const {
    if (hit) prefetch(&triangles[hit.triangle]);
  }
  std::size_t bytes() const { return triangles.capacity() * sizeof(PathTriangle) + bsdfs.capacity() * sizeof(SurfaceBsdf); }

  const World& world;
  std::vector<PathTriangle> triangles;
  std::vector<SurfaceBsdf> bsdfs;                      ///< of every material
  SurfaceBsdf sensor = SurfaceBsdf::diffuse(Rgb(pi));  ///< f = 1
};

}  // namespace gibench::pathtracer
