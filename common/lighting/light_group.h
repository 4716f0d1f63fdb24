/// Groups of lights: each has a sample of its own at every surface point.
#pragma once

#include <cstdint>

namespace gibench {

/// Lights that share a sample, by where they are. A sun takes no sample from a sky, and neither takes one from a lamp.
enum class LightGroup : std::uint8_t { placed, directional, environment };
inline constexpr std::uint32_t most_light_groups = 3;
/// Whether a place on the light is drawn: a directional one lies in one direction.
constexpr bool has_places(LightGroup group) { return group != LightGroup::directional; }

}  // namespace gibench
