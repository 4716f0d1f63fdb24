/// Tables, cases and joinery, standing on y = 0. Boards reach two millimetres into one another.
#pragma once

#include "scenes/generators/shapes.h"

namespace gibench::generators {

/// A table with a frame under its top and turned legs; `size` is width, height and depth in metres, about the y axis.
Mesh table(const Vec3d& size, int columns);
/// A low round table on three legs.
Mesh side_table(double radius, double height);

/// An open case with shelves; its back at z = 0, its front at z = depth, x from 0 to the width.
struct CaseShape {
  double width = 1.2, height = 2.0, depth = 0.3;  ///< metres
  int shelves = 5;                                ///< boards that carry something, the lowest included
  double board = 0.024;                           ///< metres
  double plinth = 0.07;                           ///< metres, the height of the lowest board's underside

  /// The upper side of a board, metres; and the room above it.
  double level(int shelf) const;
  double room() const;
};
Mesh bookcase(const CaseShape& shape);

/// A closed cupboard: a body, and doors with knobs a little in front of it. Its back at z = 0.
Mesh cupboard(const Vec3d& size, int doors);

/// A leaf with four panels in its frame, a knob and hinges; its back at z = 0, x from 0 to the width.
Mesh panelled_door(double width, double height);

/// A ladder that leans: feet at z = `lean`, top at z = 0, x from 0 to the width.
Mesh ladder(double width, double height, double lean, int rungs);

/// A ribbed radiator with its pipe, its back at z = 0, x from 0 to the width.
Mesh radiator(double width, double height);

/// A picture in its frame, its back at z = 0, about the origin.
struct Picture {
  Mesh frame, canvas;
};
Picture picture(double width, double height);

}  // namespace gibench::generators
