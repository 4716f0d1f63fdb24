/// The rounding of positions and rays: the distance off a surface at which rays begin and end.
#pragma once

namespace gibench {

// A position is rounded relative to its coordinates, Embree's intersection relative to the triangle's extent. Of four
// million rays from each of four tilted and moved rooms, 2^-22 of both was the least at which none met its own triangle
// again; four and two times that leave room, and let walls of a millimetre stand in scenes of a kilometre.
constexpr float offset_per_coordinate = 0x1p-20F;
constexpr float offset_per_extent = 0x1p-21F;

/// Metres; `coordinate`: the largest of the position, `extent`: the largest of the triangle's edges.
constexpr float ray_offset(float coordinate, float extent) {
  return offset_per_coordinate * coordinate + offset_per_extent * extent;
}

}  // namespace gibench
