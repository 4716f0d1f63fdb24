/// The normalised reflection lobe of the modified Phong BRDF (Lafortune and Willems 1994):
/// f = ks (n+2)/(2π) max(0, r·ω)ⁿ, r the mirror direction of the viewer. Local frame: z is the normal.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

struct PhongLobe {
  Rgb specular;           ///< ks
  float exponent = 1.0F;  ///< n ≥ 0

  static Vec3 mirrored(const Vec3& outgoing) { return {-outgoing.x, -outgoing.y, outgoing.z}; }

  /// BRDF value without the cosine, 1/sr.
  Rgb evaluate(const Vec3& outgoing, const Vec3& incoming) const {
    return specular * ((exponent + 2.0F) / (2.0F * pi) * power_of_cosine(outgoing, incoming));
  }
  /// Density of sample(), 1/sr; directions below the surface carry the rest of the probability.
  float pdf(const Vec3& outgoing, const Vec3& incoming) const {
    return (exponent + 1.0F) / (2.0F * pi) * power_of_cosine(outgoing, incoming);
  }
  /// Direction about r with density ∝ (r·ω)ⁿ; it may lie below the surface, where the lobe carries nothing.
  Vec3 sample(const Vec3& outgoing, Vec2 u) const {
    const float cosine = std::pow(1.0F - u.x, 1.0F / (exponent + 1.0F));
    const float sine = std::sqrt(std::max(0.0F, 1.0F - cosine * cosine));
    const float angle = 2.0F * pi * u.y;
    return Frame(mirrored(outgoing)).to_world({sine * std::cos(angle), sine * std::sin(angle), cosine});
  }

 private:
  float power_of_cosine(const Vec3& outgoing, const Vec3& incoming) const {
    const float cosine = glm::dot(mirrored(outgoing), incoming);
    return cosine > 0.0F ? std::pow(std::min(1.0F, cosine), exponent) : 0.0F;
  }
};

}  // namespace gibench
