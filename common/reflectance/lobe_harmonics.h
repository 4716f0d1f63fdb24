/// A BRDF's lobe as a sum of spherical harmonics of the incoming direction, by outgoing direction.
#pragma once

#include <vector>

#include "common/reflectance/spherical_harmonics.h"
#include "common/scene/scene.h"

namespace gibench {

/// f(in, out) ≈ Σ_k ρ_k(out) h_k(in) over the upper hemisphere (Wang, Zhu, Humphreys 2007, Eq. 5; Kautz, Sloan, Snyder 2002), of
/// everything in a material but its diffuse part. The ρ_k minimise ∫ cos (f − Σ ρ_k h_k)² over the hemisphere, where light
/// arrives, with a slight pull towards zero on all but the constant; light of one radiance is reflected exactly. A mirror is
/// fitted as the limit of ever narrower lobes. The surface is isotropic, so that a table over the angle of `out` holds all.
class LobeHarmonics {
 public:
  explicit LobeHarmonics(const Material& material);

  /// ρ_k for a unit direction on the side of the unit normal, in the world's axes; zero below the horizon.
  RgbHarmonics coefficients(const Vec3& normal, const Vec3& toward_viewer) const;

 private:
  std::vector<RgbHarmonics> by_angle_;  ///< `out` in the xz plane, evenly spaced in the angle to the normal
};

}  // namespace gibench
