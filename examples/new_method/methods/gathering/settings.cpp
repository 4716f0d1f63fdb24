#include "methods/gathering/settings.h"

#include "common/method/parameter_table.h"

namespace gibench::gathering {

namespace {

const ParameterTable<Settings>& table() {
  static const ParameterTable<Settings> made{
      parameter("rays", &Settings::rays, 1, 65536, "directions in which each sample gathers light, a count"),
      parameter("points", &Settings::points, 1, 1048576, "surface points over which the mean light is taken, a count"),
  };
  return made;
}

}  // namespace

ParameterSchema settings_schema() { return table().schema(); }

Settings settings_from(const Parameters& parameters) { return table().read(parameters); }

}  // namespace gibench::gathering
