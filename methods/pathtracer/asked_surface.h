/// The surface point that a value is asked of, and how light that arrives there counts towards the value.
#pragma once

#include "common/lighting/scene_lights.h"
#include "common/method/quantity.h"
#include "common/reflectance/bsdf.h"
#include "methods/pathtracer/path_scene.h"

namespace gibench::pathtracer {

/// Every quantity is `emitted` + `factor` · ∫ f(out, in) L(in) cos θ d(in) with the lobe of `bsdf`:
/// radiance with the surface's own; irradiance with f = 1; radiosity as π times the radiance, of a diffuse surface in any
/// direction, of any other in a cosine-distributed direction, drawn anew for each path.
struct AskedSurface {
  /// radiance, irradiance or radiosity; `toward_viewer` is used for radiance alone.
  AskedSurface(const PathScene& scene, const SceneLights& lights, Quantity quantity, const SurfaceSample& sample,
               const Vec3& toward_viewer);

  Vec3 position, normal;
  Vec3 origin;                        ///< of rays that leave
  const SurfaceBsdf* bsdf = nullptr;  ///< of the PathScene; unset where the value is zero
  float factor = 1.0F;
  Vec3 out{0.0F};          ///< unit, in world space, where it is not drawn
  bool draws_out = false;  ///< `out` is drawn for each path
  Rgb emitted;             ///< what the surface itself gives to the value
  bool lit = true;         ///< false: the value is zero
};

}  // namespace gibench::pathtracer
