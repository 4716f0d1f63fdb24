/// The shell of a room: walls with openings, window bars, curtains, skirting. Metres; fronts look into the room.
#pragma once

#include <array>
#include <vector>

#include "scenes/generators/shapes.h"

namespace gibench::generators {

/// A hole in a wall, in the wall's own plane.
struct Opening {
  double left, low, right, high;  ///< metres
};

/// A wall in the x-y plane from (0, 0) to (width, height) that faces +z, with openings whose reveals go back to
/// z = -`depth`. Openings do not overlap.
Mesh wall(double width, double height, const std::vector<Opening>& openings = {}, double depth = 0.25);

/// The frame of an opening and the bars that divide it into columns × rows panes, in the plane z = -`back`.
Mesh window_bars(const Opening& opening, int columns, int rows, double bar, double back);

/// A curtain of thin cloth in the x-y plane, `folds` deep waves towards +z, wider at its hem; reflects on both sides.
Mesh curtain(double width, double height, int folds, RandomStream& random);

/// A skirting board along a wall from x = 0 to the width, its back a millimetre off z = 0.
Mesh skirting(double width);

/// A floor of loose boards in three tones on y = 0, x from 0 to the width and z from 0 to the depth, a millimetre apart; they
/// lie a millimetre above what carries them, which is the last part.
struct Floorboards {
  std::array<Mesh, 3> tones;
  Mesh under;
};
Floorboards floorboards(double width, double depth, double board_width, RandomStream& random);

/// Four walls that look into a room of x, y, z from 0 to its size. They reach two millimetres past their edges and 3 cm
/// below the floor, so that no ray slips between them. `openings` are those of the walls at z = 0, at x = 0 (from z = depth
/// to 0), at z = depth (from x = width to 0) and at x = width (from z = 0 to depth): as each is seen from inside, from left to
/// right. `reveal` is the thickness of the walls, metres.
Mesh room_walls(const Vec3d& size, const std::array<std::vector<Opening>, 4>& openings, double reveal);

/// The ceiling of such a room; of its openings left and right are in x, low and high in z.
Mesh room_ceiling(const Vec3d& size, const std::vector<Opening>& openings, double reveal);

}  // namespace gibench::generators
