/// Vessels and what stands beside them: turned, with walls of a thickness, standing on y = 0 about the y axis.
#pragma once

#include "scenes/generators/shapes.h"

namespace gibench::generators {

Mesh plate(double radius);
Mesh bowl(double radius, double height);
/// A cup of 8 cm with its handle towards +x.
Mesh cup();
/// A pot of about 14 cm with its lid, spout towards +x and handle.
Mesh teapot();
/// A vase whose belly is `belly` times as wide as its foot.
Mesh vase(double height, double foot_radius, double belly);
/// A candle holder with a candle in it, in two closed parts.
Mesh candlestick(double height);

}  // namespace gibench::generators
