/// A colour in four floats, so that the three that count are one aligned load.
#pragma once

#include "common/core/rgb.h"

namespace gibench::spectral {

struct alignas(16) Rgb4 {
  float r = 0.0F, g = 0.0F, b = 0.0F, unused = 0.0F;

  Rgb4() = default;
  Rgb4(const Rgb& c) : r(c.r), g(c.g), b(c.b) {}
  operator Rgb() const { return {r, g, b}; }
};

}  // namespace gibench::spectral
