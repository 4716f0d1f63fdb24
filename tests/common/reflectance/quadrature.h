/// Integrals over the hemisphere, to hold lobes against.
#pragma once

#include <cmath>

#include "common/core/vec.h"

namespace gibench::test {

/// The direction of polar cosine z and azimuth, in the frame whose z axis is the normal.
inline Vec3 direction_of(double cosine, double azimuth) {
  const double sine = std::sqrt(1.0 - cosine * cosine);
  return {static_cast<float>(sine * std::cos(azimuth)), static_cast<float>(sine * std::sin(azimuth)), static_cast<float>(cosine)};
}

/// ∫ g(ω) dω over cosines [low, high] and azimuths [from, to] by the midpoint rule on steps × steps cells, even in the
/// polar angle: narrow lobes about the normal are resolved like any other.
template <class Function>
double integrate(double low, double high, double from, double to, int steps, const Function& g) {
  const double nearest = std::acos(high), step = (std::acos(low) - nearest) / steps;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double polar = nearest + step * (i + 0.5);
    for (int j = 0; j < steps; ++j)
      sum += std::sin(polar) * static_cast<double>(g(direction_of(std::cos(polar), from + (to - from) * (j + 0.5) / steps)));
  }
  return sum * step * (to - from) / steps;
}

template <class Function>
double integrate_hemisphere(int steps, const Function& g) {
  return integrate(0.0, 1.0, 0.0, 2.0 * pi_double, steps, g);
}

}  // namespace gibench::test
