/// Real spherical harmonics of the first four bands: 16 functions, orthonormal on the sphere.
#pragma once

#include <array>
#include <cstddef>

#include "common/core/rgb.h"
#include "common/core/vec.h"

namespace gibench {

inline constexpr std::size_t harmonic_count = 16;
using Harmonics = std::array<float, harmonic_count>;
using RgbHarmonics = std::array<Rgb, harmonic_count>;

/// h_{l(l+1)+m} of a unit direction, l = 0…3, m = −l…l; without the Condon–Shortley sign (Sloan 2008, appendix A2).
inline Harmonics spherical_harmonics(const Vec3& w) {
  const float x = w.x, y = w.y, z = w.z, xx = x * x, yy = y * y, zz = z * z;
  return {0.282094792F,
          0.488602512F * y,
          0.488602512F * z,
          0.488602512F * x,
          1.092548431F * x * y,
          1.092548431F * y * z,
          0.315391565F * (3.0F * zz - 1.0F),
          1.092548431F * x * z,
          0.546274215F * (xx - yy),
          0.590043590F * y * (3.0F * xx - yy),
          2.890611443F * x * y * z,
          0.457045799F * y * (5.0F * zz - 1.0F),
          0.373176333F * z * (5.0F * zz - 3.0F),
          0.457045799F * x * (5.0F * zz - 1.0F),
          1.445305721F * z * (xx - yy),
          0.590043590F * x * (xx - 3.0F * yy)};
}

/// The coefficients in the world's axes of a function given by its coefficients in a frame's.
RgbHarmonics to_world(const RgbHarmonics& local, const Frame& frame);

}  // namespace gibench
