#include "methods/pathtracer/settings.h"

namespace gibench::pathtracer {

ParameterSchema Settings::schema() {
  const Settings defaults;
  const auto whole = [](auto value) { return static_cast<std::int64_t>(value); };
  return {
      {"samples", whole(defaults.samples), 1, 1 << 24, {}, "paths for each value"},
      {"first_sample",
       whole(defaults.first_sample),
       0,
       1U << 31,
       {},
       "index of the first path: a run with first_sample n goes on where one with n samples stopped"},
      {"replicates",
       whole(defaults.replicates),
       1,
       256,
       {},
       "independently scrambled sequences that the paths are dealt to in turn; 1 gives no variance but the best stratification"},
      {"roulette_bounce", whole(defaults.roulette_bounce), 1, 64, {}, "bounces before Russian roulette may end a path"},
  };
}

Settings Settings::from(const Parameters& parameters) {
  Settings settings;
  settings.samples = static_cast<std::uint64_t>(parameters.whole("samples"));
  settings.first_sample = static_cast<std::uint64_t>(parameters.whole("first_sample"));
  settings.replicates = static_cast<std::uint64_t>(parameters.whole("replicates"));
  settings.roulette_bounce = static_cast<int>(parameters.whole("roulette_bounce"));
  return settings;
}

}  // namespace gibench::pathtracer
