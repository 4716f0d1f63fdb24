/// The state of a series of bounces, judged from its last two.
#pragma once

#include <algorithm>

#include "common/core/rgb.h"
#include "methods/meshless/coefficients.h"

namespace gibench::meshless {

/// How far a series has come, channel by channel.
struct Convergence {
  RgbDouble ratio;         ///< of the last bounce to the one before, area means
  RgbDouble tail_factor;   ///< Σ of all later bounces over the last one, were the ratio to stay
  double residual = 0.0;   ///< share of the solution in the bounces left out
  double departure = 0.0;  ///< share of the solution by which that tail would be wrong
};

/// `sum`: of all bounces so far. Means over the surfaces are those of the coarsest samples.
Convergence judge(const Coefficients& last, const Coefficients& before, const Coefficients& sum);

/// Adds `factor` times another function.
void add_scaled(Coefficients& sum, const Coefficients& term, const Rgb& factor);

}  // namespace gibench::meshless
