/// The colour spaces of FLIP (Andersson et al. 2020, sections 4.1 and 4.2).
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "common/core/rgb.h"

namespace gibench {

/// Three coordinates of a colour space.
struct ColourTriple {
  float x = 0.0F, y = 0.0F, z = 0.0F;
};

/// Linear sRGB to XYZ over the D65 white, so that white is (1, 1, 1).
inline ColourTriple relative_xyz(const Rgb& c) {
  // sRGB's chromaticities exactly, as ratios of integers; white is the sum of each row.
  constexpr double xr = 10135552.0 / 24577794.0, xg = 8788810.0 / 24577794.0, xb = 4435075.0 / 24577794.0;
  constexpr double yr = 2613072.0 / 12288897.0, yg = 8788810.0 / 12288897.0, yb = 887015.0 / 12288897.0;
  constexpr double zr = 1425312.0 / 73733382.0, zg = 8788810.0 / 73733382.0, zb = 70074185.0 / 73733382.0;
  constexpr double xw = xr + xg + xb, yw = yr + yg + yb, zw = zr + zg + zb;
  return {static_cast<float>(xr / xw) * c.r + static_cast<float>(xg / xw) * c.g + static_cast<float>(xb / xw) * c.b,
          static_cast<float>(yr / yw) * c.r + static_cast<float>(yg / yw) * c.g + static_cast<float>(yb / yw) * c.b,
          static_cast<float>(zr / zw) * c.r + static_cast<float>(zg / zw) * c.g + static_cast<float>(zb / zw) * c.b};
}

/// The inverse of relative_xyz.
inline Rgb rgb_of_relative_xyz(const ColourTriple& c) {
  constexpr float xw = 0.950428545F, zw = 1.088900371F;
  const float x = c.x * xw, y = c.y, z = c.z * zw;
  return {3.241003275F * x - 1.537398934F * y - 0.498615861F * z, -0.969224334F * x + 1.875930071F * y + 0.041554224F * z,
          0.055639423F * x - 0.204011202F * y + 1.057148933F * z};
}

/// The opponent space YCxCz, linear in light: what the contrast sensitivity functions filter.
inline ColourTriple ycxcz(const Rgb& c) {
  const ColourTriple xyz = relative_xyz(c);
  return {116.0F * xyz.y - 16.0F, 500.0F * (xyz.x - xyz.y), 200.0F * (xyz.y - xyz.z)};
}
inline Rgb rgb_of_ycxcz(const ColourTriple& c) {
  const float y = (c.x + 16.0F) / 116.0F;
  return rgb_of_relative_xyz({y + c.y / 500.0F, y, y - c.z / 200.0F});
}

/// Cube root of a normal x > 0 to float precision: a guess from the exponent's third and two steps of Halley's method,
/// written so that the compiler makes vectors of it, as it cannot of std::cbrt.
inline float cube_root(float x) {
  float root = std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) / 3U + 709921077U);
  for (int step = 0; step < 2; ++step) {
    const float cube = root * root * root;
    root *= (cube + 2.0F * x) / (2.0F * cube + x);
  }
  return root;
}

/// CIE 1976 L*a*b* with the Hunt effect: chroma counts for less where it is dark, a and b times 0.01 L.
inline ColourTriple hunt_lab(const Rgb& c) {
  constexpr float delta = 6.0F / 29.0F;
  const auto compressed = [](float t) {
    const float dark = t * (1.0F / (3.0F * delta * delta)) + 4.0F / 29.0F;
    const float light = cube_root(std::max(t, delta * delta * delta));
    return t > delta * delta * delta ? light : dark;
  };
  const ColourTriple xyz = relative_xyz(c);
  const float fx = compressed(xyz.x), fy = compressed(xyz.y), fz = compressed(xyz.z);
  const float lightness = 116.0F * fy - 16.0F;
  return {lightness, 0.01F * lightness * 500.0F * (fx - fy), 0.01F * lightness * 200.0F * (fy - fz)};
}

/// Abasi et al. (2020): city-block distance in lightness plus Euclidean distance in chroma.
inline float hyab(const ColourTriple& a, const ColourTriple& b) {
  const float dy = a.y - b.y, dz = a.z - b.z;
  return std::abs(a.x - b.x) + std::sqrt(dy * dy + dz * dz);
}

}  // namespace gibench
