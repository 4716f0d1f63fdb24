/// Chairs and upholstered seats, standing on y = 0, their fronts towards +z. Made of loose parts that reach into each other.
#pragma once

#include "scenes/generators/shapes.h"

namespace gibench::generators {

/// What stands and what one sits on.
struct Seat {
  Mesh frame, upholstery;
};

/// A chair with turned round legs, stretchers, a back of spindles and a cushion. `columns` round each leg.
Seat chair(int columns);

/// A sofa for `places` on turned feet: 0.78 m for each place and 0.4 m for the arms; one place is an armchair.
Seat sofa(int places);

/// A square pillow of that size, standing upright about the origin and facing +z.
Mesh pillow(double size);

}  // namespace gibench::generators
