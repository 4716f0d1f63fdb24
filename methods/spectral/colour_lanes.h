/// Eight colours side by side.
#pragma once

#include <cstddef>

#include "common/core/lanes.h"
#include "methods/spectral/rgb4.h"

namespace gibench::spectral {

/// A colour in every lane.
struct ColourLanes {
  Lanes r = all_lanes(0.0F), g = all_lanes(0.0F), b = all_lanes(0.0F);

  void add(const Lanes& factor, const Rgb4& colour) {
    r += factor * all_lanes(colour.r);
    g += factor * all_lanes(colour.g);
    b += factor * all_lanes(colour.b);
  }
  void operator+=(const ColourLanes& other) { r += other.r, g += other.g, b += other.b; }
  void operator*=(const Lanes& factor) { r *= factor, g *= factor, b *= factor; }
};

/// Colour by colour into eight places.
inline void store(const ColourLanes& colours, Rgb4* out) {
  const auto write = [&](std::size_t i, const Lanes& two) { store_lanes(out + i, two); };
  // Within each half of four: r g r g and b 0 b 0, then r g b 0.
  const Lanes zero = all_lanes(0.0F);
  const Lanes rg01 = __builtin_shufflevector(colours.r, colours.g, 0, 8, 1, 9, 4, 12, 5, 13),
              rg23 = __builtin_shufflevector(colours.r, colours.g, 2, 10, 3, 11, 6, 14, 7, 15),
              b01 = __builtin_shufflevector(colours.b, zero, 0, 8, 1, 9, 4, 12, 5, 13),
              b23 = __builtin_shufflevector(colours.b, zero, 2, 10, 3, 11, 6, 14, 7, 15);
  const Lanes c04 = __builtin_shufflevector(rg01, b01, 0, 1, 8, 9, 4, 5, 12, 13),
              c15 = __builtin_shufflevector(rg01, b01, 2, 3, 10, 11, 6, 7, 14, 15),
              c26 = __builtin_shufflevector(rg23, b23, 0, 1, 8, 9, 4, 5, 12, 13),
              c37 = __builtin_shufflevector(rg23, b23, 2, 3, 10, 11, 6, 7, 14, 15);
  write(0, __builtin_shufflevector(c04, c15, 0, 1, 2, 3, 8, 9, 10, 11));
  write(2, __builtin_shufflevector(c26, c37, 0, 1, 2, 3, 8, 9, 10, 11));
  write(4, __builtin_shufflevector(c04, c15, 4, 5, 6, 7, 12, 13, 14, 15));
  write(6, __builtin_shufflevector(c26, c37, 4, 5, 6, 7, 12, 13, 14, 15));
}

}  // namespace gibench::spectral
