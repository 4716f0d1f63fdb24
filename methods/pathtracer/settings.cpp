#include "methods/pathtracer/settings.h"

#include "common/method/parameter_table.h"

namespace gibench::pathtracer {

namespace {

const ParameterTable<Settings>& table() {
  constexpr double most = 4294967295.0;  // sample numbers are 32 bits wide
  static const ParameterTable<Settings> made{
      parameter("samples", &Settings::samples, 1, most, "paths for each value, in all, over replicates"),
      parameter("first_sample", &Settings::first_sample, 0, most,
                "number of the first path: continues a sequence, nothing is repeated"),
      parameter("replicates", &Settings::replicates, 1, 1024,
                "independently scrambled sequences that the paths are dealt to in turn; variances need two"),
      parameter("light_samples", &Settings::light_samples, 1, 64,
                "ways to each group of lights (lamps, directional lights, environments) tried at each vertex"),
      parameter("roulette_start", &Settings::roulette_start, 1, 1000, "reflections before a path may end at random"),
      parameter("roulette_below", &Settings::roulette_below, 1e-6, 1.0,
                "a path may end at random once it carries less than this share"),
  };
  return made;
}

}  // namespace

ParameterSchema settings_schema() { return table().schema(); }

Settings settings_from(const Parameters& parameters) { return table().read(parameters); }

}  // namespace gibench::pathtracer
