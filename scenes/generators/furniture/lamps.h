/// Lamps in three parts: a stand, a shade of thin cloth or glass, and what glows.
#pragma once

#include "scenes/generators/shapes.h"

namespace gibench::generators {

struct Lamp {
  Mesh stand;
  Mesh shade;  ///< an open, thin surface: reflects on both sides
  Mesh bulb;   ///< glows
};

/// On the floor, `height` metres to the middle of the shade.
Lamp floor_lamp(double height);
/// On a table: a belly, a shade, about 0.5 m.
Lamp table_lamp();
/// A reading lamp with a shade that is long along x, about 0.42 m high.
Lamp reading_lamp();
/// Hanging from y = 0 down to y = -drop: a cord and a wide shade with the bulb in it.
Lamp pendant(double drop, double radius);
/// Hanging from y = 0: a rod down to y = -drop, a hub and `arms` bent arms with a glowing candle on each.
Lamp chandelier(double drop, double radius, int arms);

}  // namespace gibench::generators
