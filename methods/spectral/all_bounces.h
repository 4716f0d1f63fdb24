/// T*: all bounces folded into the transfer matrix, for albedos that do not change (Wang et al. 2007, section 3.2).
#pragma once

#include <span>
#include <vector>

#include "methods/spectral/basis.h"
#include "methods/spectral/transfer_matrix.h"
#include "methods/spectral/trial_lights.h"

namespace gibench::spectral {

/// With B = S R T^s, the light of one bounce from basis to basis (S the projection, R the reflectances ρ/π), the light of all is
/// c = c₀ + B c₀ + B² c₀ + … = G c₀, and the irradiance T^s G c₀: T* = T^s G. G is the series of `most_bounces` terms where that
/// is given (> 0), else (1 − B)⁻¹. One matrix where all surfaces are grey, else one per channel. Compressed as T^s was, on rows
/// of its own.
std::vector<TransferMatrix> all_bounces(const SpectralBasis& basis, const TransferMatrix& one_bounce,
                                        std::span<const Rgb4> reflectance, std::span<const double> areas, int most_bounces,
                                        const TrialLights& lights, double compression_error, Task& task);

}  // namespace gibench::spectral
