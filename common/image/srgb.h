/// The sRGB transfer functions (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "common/core/rgb.h"

namespace gibench {

/// Encoded value in [0, 1] to linear; sign and values above one are carried through.
inline float srgb_to_linear(float encoded) {
  return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}
/// Linear value to encoded.
inline float linear_to_srgb(float linear) {
  return linear <= 0.0031308F ? 12.92F * linear : 1.055F * std::pow(linear, 1.0F / 2.4F) - 0.055F;
}
inline Rgb srgb_to_linear(const Rgb& c) { return {srgb_to_linear(c.r), srgb_to_linear(c.g), srgb_to_linear(c.b)}; }
inline Rgb linear_to_srgb(const Rgb& c) { return {linear_to_srgb(c.r), linear_to_srgb(c.g), linear_to_srgb(c.b)}; }

/// Clamped to [0, 1]; a NaN becomes 0.
inline float clamp_unit(float x) { return x > 0.0F ? std::min(x, 1.0F) : 0.0F; }
inline Rgb clamp_unit(const Rgb& c) { return {clamp_unit(c.r), clamp_unit(c.g), clamp_unit(c.b)}; }

/// Nearest of the 256 levels of an 8-bit picture, of a linear value clamped to [0, 1].
inline std::uint8_t srgb_byte(float linear) {
  return static_cast<std::uint8_t>(std::lround(255.0F * linear_to_srgb(clamp_unit(linear))));
}

}  // namespace gibench
