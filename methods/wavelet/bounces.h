/// The Neumann series of indirect light on the basis: the direct transport operator applied bounce by bounce.
#pragma once

#include <span>
#include <string>

#include "common/finite_elements/bounce_series.h"
#include "common/method/stage_report.h"
#include "methods/wavelet/global_operator.h"
#include "methods/wavelet/transform.h"
#include "methods/wavelet/transport_operator.h"

namespace gibench::wavelet {

struct IndirectLight {
  Termination termination = Termination::done;
  std::string message;
  int bounces = 0;
  double residual = 0.0;
  Coefficients<Rgb> irradiance;  ///< W/m²
};

/// `direct`: incident irradiance straight from the lights; `reflectance`: albedo of every element.
IndirectLight bounce(const Elements& elements, const TransportOperator& transport, std::span<const Rgb> direct,
                     std::span<const Rgb> reflectance, const BounceBound& bound, Task& task);

/// All bounces by an operator that holds them; `gathered`: it holds all but the last, which the direct one adds.
IndirectLight all_bounces(const Elements& elements, const TransportOperator& transport, const GlobalOperator& global,
                          bool gathered, std::span<const Rgb> direct, std::span<const Rgb> reflectance, Task& task);

/// What compression takes of the indirect light where direct light is the same everywhere: 1 − its power over that of the series
/// without compression, which `bound` ends; negative where there is more.
double lost_to_compression(const Elements& elements, const TransportOperator& transport, const GlobalOperator& global,
                           bool gathered, std::span<const Rgb> reflectance, const BounceBound& bound, Task& task);

}  // namespace gibench::wavelet
