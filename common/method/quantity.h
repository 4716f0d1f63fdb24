/// The quantities that a method can be asked for at a surface sample.
#pragma once

#include "common/effects/component.h"

namespace gibench {

/// A kind of light, with its unit.
enum class Quantity {
  radiance,       ///< leaving towards the viewer, W/(m² sr)
  irradiance,     ///< arriving on the sample's side, W/m²
  radiosity,      ///< leaving the sample's side in all directions, emission included, W/m²
  accessibility,  ///< cosine-weighted share of the hemisphere that sees no surface, [0, 1]
};

}  // namespace gibench
