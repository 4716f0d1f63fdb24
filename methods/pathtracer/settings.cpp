#include "methods/pathtracer/settings.h"

namespace gibench::pathtracer {

ParameterSchema settings_schema() {
  const double most = 4294967295.0;  // sample numbers are 32 bits wide
  return {
      {"samples", std::int64_t{64}, 1, most, {}, "paths for each value, over all replicates"},
      {"first_sample", std::int64_t{0}, 0, most, {}, "number of the first path: continues a sequence, nothing is repeated"},
      {"replicates",
       std::int64_t{16},
       1,
       1024,
       {},
       "independently scrambled sequences that the paths are dealt to in turn; variances need two"},
      {"light_samples", std::int64_t{1}, 1, 64, {}, "ways to lights tried at each vertex of a path"},
      {"roulette_start", std::int64_t{3}, 1, 1000, {}, "reflections before a path may end at random"},
      {"roulette_below", 0.15, 1e-6, 1.0, {}, "a path may end at random once it carries less than this share"},
  };
}

Settings settings_from(const Parameters& parameters) {
  Settings settings;
  settings.samples = static_cast<std::uint64_t>(parameters.whole("samples"));
  settings.first_sample = static_cast<std::uint64_t>(parameters.whole("first_sample"));
  settings.replicates = static_cast<std::uint32_t>(parameters.whole("replicates"));
  settings.light_samples = static_cast<std::uint32_t>(parameters.whole("light_samples"));
  settings.roulette_start = static_cast<int>(parameters.whole("roulette_start"));
  settings.roulette_below = static_cast<float>(parameters.real("roulette_below"));
  return settings;
}

}  // namespace gibench::pathtracer
