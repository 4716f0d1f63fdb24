/// Pot plants whose leaves are loose, thin pieces.
#pragma once

#include "scenes/generators/shapes.h"

namespace gibench::generators {

struct Plant {
  Mesh pot, earth, stems;
  Mesh leaves;  ///< open and thin: reflect on both sides; no two share a vertex
};

/// Long arching leaves out of the middle, `height` metres above the pot's rim.
Plant grassy_plant(double pot_radius, double height, int leaves, RandomStream& random);
/// Branching stems with broad leaves on stalks.
Plant leafy_plant(double pot_radius, double height, int stems, int leaves_per_stem, RandomStream& random);

}  // namespace gibench::generators
