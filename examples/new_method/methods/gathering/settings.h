/// The settings of gathering.
#pragma once

#include "common/method/parameters.h"

namespace gibench::gathering {

/// Each member is initialised with the default of its parameter.
struct Settings {
  int rays = 16;      ///< directions in which a sample looks around
  int points = 1024;  ///< of the surfaces, at which the scene's mean light is taken
};

ParameterSchema settings_schema();
Settings settings_from(const Parameters& parameters);

}  // namespace gibench::gathering
