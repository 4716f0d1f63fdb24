/// One way from a surface point to a light.
#pragma once

#include "common/core/rgb.h"
#include "common/ray/ray.h"

namespace gibench {

/// The estimate of straight light is f · cos · radiance / pdf where nothing lies between.
struct LightSample {
  Vec3 direction{0.0F};      ///< unit, from the surface point towards the light
  Vec3 target{0.0F};         ///< where the way ends, metres, just off the light's surface; unused at infinity
  bool at_infinity = false;  ///< an environment or a directional light
  bool delta = false;        ///< a point, spot or directional light, which no other technique finds
  Rgb radiance;              ///< W/(m² sr); of a delta light its irradiance on a facing surface, W/m²
  float pdf = 0.0F;          ///< 1/sr, choice of the light included; of a delta light its probability; 0: no light here

  /// The ray that must be free.
  Ray shadow_ray(const Vec3& origin) const {
    if (at_infinity) return {origin, 0.0F, direction};
    return {origin, 0.0F, target - origin, nearly_there};
  }

 private:
  /// Short of the target by some roundings: a punctual light may lie in a surface, and is seen from both its sides.
  static constexpr float nearly_there = 1.0F - 0x1p-18F;
};

}  // namespace gibench
