/// One light path from a surface sample: next-event estimation at every vertex, combined with the directions of
/// the surface's own lobes by multiple importance sampling (Veach 1997).
#pragma once

#include <optional>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/sobol.h"
#include "common/lighting/light_sampler.h"
#include "common/ray/ray_stream.h"
#include "common/ray/world.h"
#include "common/reflectance/scattering.h"

namespace gibench::pathtracer {

/// One path's estimate: light straight from the lights to the surface asked about, and all the rest.
struct PathLight {
  Rgb direct, indirect;
};

/// Immutable, shared by all threads.
class PathEstimator {
 public:
  /// max_bounces: reflections allowed between a light and the surface asked about; empty: no bound.
  PathEstimator(const World& world, const LightSampler& lights, std::optional<int> max_bounces, int roulette_bounce);

  /// W/m² on the sample's side.
  PathLight irradiance(const SurfaceSample& at, SobolSampler& random, RayStream& rays) const;
  /// W/(m² sr) leaving towards the unit direction `toward_viewer`, the surface's own emission in `direct`.
  PathLight radiance(const SurfaceSample& at, const Vec3& toward_viewer, SobolSampler& random, RayStream& rays) const;
  /// W/m² leaving the sample's side: radiance in a cosine-distributed direction, times π.
  PathLight radiosity(const SurfaceSample& at, SobolSampler& random, RayStream& rays) const;
  /// 1 where a cosine-distributed ray meets no surface, else 0.
  float accessibility(const SurfaceSample& at, SobolSampler& random, RayStream& rays) const;

 private:
  struct Vertex;
  struct Walk;
  void collect_by_light(Walk& walk, const Vertex& vertex) const;
  bool extend(Walk& walk, Vertex& vertex) const;
  bool survives(Walk& walk) const;
  PathLight trace(const SurfaceSample& at, const Scattering& surface, const Vec3& toward_viewer, SobolSampler& random,
                  RayStream& rays) const;

  const World& world_;
  const LightSampler& lights_;
  std::optional<int> max_bounces_;
  int roulette_bounce_;
  std::vector<Scattering> scattering_;  ///< of every material
  std::vector<std::uint32_t> material_of_object_;
};

}  // namespace gibench::pathtracer
