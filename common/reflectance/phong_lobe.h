/// The normalised reflection lobe of modified Phong (Lafortune and Willems 1994), in the frame whose z axis is
/// the surface normal.
#pragma once

#include <cmath>

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

/// f = ks (n+2)/(2π) max(0, r·in)^n, where r mirrors `out` about the normal.
struct PhongLobe {
  Rgb specular;           ///< ks, [0, 1]
  float exponent = 0.0F;  ///< n ≥ 0

  /// f, 1/sr, without the cosine. Both directions leave the surface, z > 0.
  Rgb value(const Vec3& out, const Vec3& in) const { return specular * ((exponent + 2.0F) * (0.5F / pi) * lobe_power(out, in)); }
  /// (n+1)/(2π) max(0, r·in)^n per solid angle: the lobe's share below the surface is sampled and rejected.
  float pdf(const Vec3& out, const Vec3& in) const { return (exponent + 1.0F) * (0.5F / pi) * lobe_power(out, in); }
  /// May lie below the surface, where it carries nothing.
  Vec3 sample(const Vec3& out, Vec2 u) const {
    // cos α = u^(1/(n+1)); its complement by expm1, which keeps narrow lobes exact.
    const float log_cosine = std::log(1.0F - u.x) / (exponent + 1.0F);
    const float cosine = std::exp(log_cosine);
    const float sine = std::sqrt(-std::expm1(2.0F * log_cosine));
    const float angle = 2.0F * pi * u.y;
    return Frame(mirrored(out)).to_world({sine * std::cos(angle), sine * std::sin(angle), cosine});
  }

 private:
  static Vec3 mirrored(const Vec3& out) { return {-out.x, -out.y, out.z}; }
  /// max(0, r·in)^n from |r − in|² = 2 − 2 r·in, exact where the cosine is near one and n is large.
  float lobe_power(const Vec3& out, const Vec3& in) const {
    const Vec3 apart = mirrored(out) - in;
    const float below_one = 0.5F * glm::dot(apart, apart);
    return below_one < 1.0F ? std::exp(exponent * std::log1p(-below_one)) : 0.0F;
  }
};

}  // namespace gibench
