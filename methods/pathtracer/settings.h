/// The settings of the path tracer.
#pragma once

#include <cstdint>

#include "common/method/parameters.h"

namespace gibench::pathtracer {

/// Each member is initialised with the default of its parameter.
struct Settings {
  std::uint64_t samples = 64;       ///< paths for each value, in all, over replicates
  std::uint64_t first_sample = 0;   ///< number of the first one: a run with those before it and this one join into one
  std::uint32_t replicates = 16;    ///< independently scrambled sequences that the paths of a value are dealt to in turn
  std::uint32_t light_samples = 1;  ///< ways to each group of lights tried at each vertex of a path
  int roulette_start = 2;           ///< reflections after which a path may end at random
  float roulette_below = 0.5F;      ///< throughput, relative to the first vertex's, under which it may
};

ParameterSchema settings_schema();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::pathtracer
