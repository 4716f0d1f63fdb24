/// The GGX microfacet lobe, in the frame whose z axis is the surface normal: Walter et al. 2007 (distribution),
/// Heitz 2014 (height-correlated Smith masking), Schlick 1994 (Fresnel), Dupuy and Benyoub 2023 (sampling).
#pragma once

#include <algorithm>
#include <cmath>

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

/// f = F(out·h) D(h) G2(out, in) / (4 out.z in.z), h the unit half vector.
struct GgxLobe {
  /// Below this the lobe is narrower than single precision resolves; α is held here by value, pdf and sample alike.
  static constexpr float smallest_alpha = 1e-4F;

  Rgb f0;              ///< Schlick reflectance at normal incidence, [0, 1]
  Rgb f90{1.0F};       ///< the same at grazing incidence, [0, 1]
  float alpha = 1.0F;  ///< roughness², [smallest_alpha, 1]

  GgxLobe() = default;
  GgxLobe(const Rgb& normal_reflectance, const Rgb& grazing_reflectance, float roughness)
      : f0(normal_reflectance), f90(grazing_reflectance), alpha(std::max(smallest_alpha, roughness * roughness)) {}

  /// F = f0 + (f90 − f0)(1 − cos)^5.
  Rgb fresnel(float cosine) const {
    const float complement = std::clamp(1.0F - cosine, 0.0F, 1.0F);
    const float squared = complement * complement;
    return f0 + (f90 - f0) * (squared * squared * complement);
  }

  /// f, 1/sr, without the cosine. Both directions leave the surface, z > 0.
  Rgb value(const Vec3& out, const Vec3& in) const {
    const Vec3 half = glm::normalize(out + in);
    // G2/(4 out.z in.z), Heitz 2014 eq. 99: the cosines that would be divided by cancel.
    const float masking = 0.5F / (out.z * slant(in) + in.z * slant(out));
    return fresnel(glm::dot(out, half)) * (distribution(half) * masking);
  }
  /// Density of sample(): G1(out) D(h) / (4 out.z) per solid angle.
  float pdf(const Vec3& out, const Vec3& in) const {
    return distribution(glm::normalize(out + in)) * 0.5F / (out.z + slant(out));
  }
  /// Mirrors `out` about a visible microfacet normal. May lie below the surface, where it carries nothing.
  Vec3 sample(const Vec3& out, Vec2 u) const {
    const Vec3 stretched = glm::normalize(Vec3(alpha * out.x, alpha * out.y, out.z));
    // A point of the spherical cap z > −stretched.z, whose height above the cap's rim is kept for the half vector.
    const float above_rim = (1.0F - u.y) * (1.0F + stretched.z);
    const float height = above_rim - stretched.z;
    const float radius = std::sqrt(std::clamp(1.0F - height * height, 0.0F, 1.0F));
    const float angle = 2.0F * pi * u.x;
    const Vec3 half = glm::normalize(
        Vec3(alpha * (radius * std::cos(angle) + stretched.x), alpha * (radius * std::sin(angle) + stretched.y), above_rim));
    return 2.0F * glm::dot(out, half) * half - out;
  }

 private:
  /// D(h) = 1/(π α² (hx²/α² + hy²/α² + hz²)²), from the sine, not from 1 − cos²: exact for small α.
  float distribution(const Vec3& half) const {
    const float squared_alpha = alpha * alpha;
    const float term = (half.x * half.x + half.y * half.y) / squared_alpha + half.z * half.z;
    return 1.0F / (pi * squared_alpha * term * term);
  }
  /// sqrt(α² sin² + cos²): cos · sqrt(1 + α² tan²), finite at grazing.
  float slant(const Vec3& w) const { return std::sqrt(alpha * alpha * (w.x * w.x + w.y * w.y) + w.z * w.z); }
};

}  // namespace gibench
