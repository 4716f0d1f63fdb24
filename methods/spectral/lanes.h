/// Eight floats at once.
#pragma once

#include <cstddef>
#include <cstdint>

namespace gibench::spectral {

constexpr std::size_t lane_count = 8;
using Lanes = float __attribute__((vector_size(32), aligned(4), may_alias));
using LanesOfShort = std::int16_t __attribute__((vector_size(16), aligned(2), may_alias));

inline Lanes load(const float* from) { return *reinterpret_cast<const Lanes*>(from); }
inline Lanes load(const std::int16_t* from) {
  return __builtin_convertvector(*reinterpret_cast<const LanesOfShort*>(from), Lanes);
}
inline Lanes all_lanes(float value) { return Lanes{value, value, value, value, value, value, value, value}; }

/// A colour in every lane.
struct ColourLanes {
  Lanes r = all_lanes(0.0F), g = all_lanes(0.0F), b = all_lanes(0.0F);

  template <class Colour>
  void add(const Lanes& factor, const Colour& colour) {
    r += factor * all_lanes(colour.r);
    g += factor * all_lanes(colour.g);
    b += factor * all_lanes(colour.b);
  }
  void operator+=(const ColourLanes& other) { r += other.r, g += other.g, b += other.b; }
};

}  // namespace gibench::spectral
