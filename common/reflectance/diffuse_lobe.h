/// The Lambertian lobe, in the frame whose z axis is the surface normal.
#pragma once

#include "common/core/rgb.h"
#include "common/core/sampling.h"

namespace gibench {

/// Reflection that is the same in every direction.
struct DiffuseLobe {
  Rgb albedo;  ///< ρ, [0, 1]

  /// f = ρ/π, 1/sr, without the cosine.
  Rgb value() const { return albedo * (1.0F / pi); }
  static float pdf(const Vec3& in) { return cosine_hemisphere_pdf(in.z); }
  static Vec3 sample(Vec2 u) { return cosine_hemisphere(u); }
};

}  // namespace gibench
