/// Unit vectors in 32 bits: the octahedral map (Meyer et al. 2010), 16 bits per coordinate; exact on the axes, good to
/// 6.5e-5 radians elsewhere: half a step in both coordinates, 1.53e-5 · √2, stretched by up to 3 in the middle of a face.
#pragma once

#include <cmath>
#include <cstdint>

#include "common/core/vec.h"

namespace gibench::meshless {

inline std::uint32_t pack_normal(const Vec3& unit) {
  const float scale = 32767.0F / (std::fabs(unit.x) + std::fabs(unit.y) + std::fabs(unit.z));
  float u = unit.x * scale, v = unit.y * scale;
  if (unit.z < 0.0F) {
    const float folded = std::copysign(32767.0F - std::fabs(v), u);
    v = std::copysign(32767.0F - std::fabs(u), v);
    u = folded;
  }
  const auto to_bits = [](float x) { return static_cast<std::uint16_t>(static_cast<std::int16_t>(std::lrint(x))); };
  return static_cast<std::uint32_t>(to_bits(u)) | static_cast<std::uint32_t>(to_bits(v)) << 16;
}

inline Vec3 unpack_normal(std::uint32_t packed) {
  const auto from_bits = [](std::uint32_t bits) {
    return static_cast<float>(static_cast<std::int16_t>(static_cast<std::uint16_t>(bits))) / 32767.0F;
  };
  float u = from_bits(packed & 0xffffU), v = from_bits(packed >> 16);
  const float z = 1.0F - std::fabs(u) - std::fabs(v);
  if (z < 0.0F) {
    const float folded = std::copysign(1.0F - std::fabs(v), u);
    v = std::copysign(1.0F - std::fabs(u), v);
    u = folded;
  }
  return glm::normalize(Vec3(u, v, z));
}

}  // namespace gibench::meshless
