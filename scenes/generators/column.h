/// A fluted column with entasis, base mouldings and capital.
#pragma once

#include "scenes/generators/mesh.h"

namespace gibench::generators {

struct ColumnShape {
  double height = 4.2;          ///< metres, from the floor to the top of the abacus
  double lower_radius = 0.34;   ///< of the shaft, metres
  double upper_radius = 0.285;  ///< of the shaft, metres
  int flutes = 20;
  int points_per_flute = 6;
  int shaft_rows = 26;
};

/// Standing on y = 0 about the y axis: three closed parts (plinth, turned part, abacus) that reach a little into
/// one another, so that no two surfaces coincide.
Mesh column(const ColumnShape& shape);

}  // namespace gibench::generators
