/// A relit frame: project the light, bounce it, reconstruct (Wang et al. 2007, figure 4).
#pragma once

#include <span>
#include <string>
#include <vector>

#include "common/finite_elements/bounce_series.h"
#include "common/reflectance/spherical_harmonics.h"
#include "methods/spectral/transfer.h"

namespace gibench::spectral {

struct Relit {
  Termination termination = Termination::done;
  std::string message;
  int bounces = 0;
  double residual = 0.0;
  std::vector<Rgb4> irradiance;         ///< indirect, W/m², one per slot
  std::vector<RgbHarmonics> harmonics;  ///< ∫ L h_k cos of the arriving indirect light, one a glossy row
};

/// `direct`: irradiance straight from the lights, W/m²; `reflectance`: ρ/π, 1/sr; one per slot. Bounce by bounce
/// Eᵢ₊₁ = T^s S (ρ/π (E + Eᵢ)), S the projection; or with T* at once.
Relit relight(const Transfer& transfer, std::span<const Rgb4> direct, std::span<const Rgb4> reflectance, const BounceBound& bound,
              Task& task);

}  // namespace gibench::spectral
