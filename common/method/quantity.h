/// What a method can be asked for at a surface sample.
#pragma once

namespace gibench {

enum class Quantity {
  radiance,       ///< leaving towards the viewer, W/(m² sr)
  irradiance,     ///< arriving on the sample's side, W/m²
  radiosity,      ///< leaving the sample's side in all directions, emission included, W/m²
  accessibility,  ///< cosine-weighted share of the hemisphere that sees no surface, [0, 1]
};

/// Light straight from the lights (no reflection before the surface asked about, its own emission included where
/// the quantity leaves it), the rest, or both.
enum class Component { total, direct, indirect };

}  // namespace gibench
