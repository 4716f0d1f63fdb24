/// The path tracer's parameters.
#pragma once

#include <cstdint>

#include "common/method/parameters.h"

namespace gibench::pathtracer {

struct Settings {
  std::uint64_t samples = 64;      ///< paths for each value
  std::uint64_t first_sample = 0;  ///< index of the first path: a later run goes on where an earlier one stopped
  std::uint64_t replicates = 16;   ///< independently scrambled sequences that the paths are dealt to
  int roulette_bounce = 3;         ///< bounces before Russian roulette

  static ParameterSchema schema();
  static Settings from(const Parameters& parameters);
};

}  // namespace gibench::pathtracer
