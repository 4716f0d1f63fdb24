/// The curve that keeps neighbours in the plane together (Morton).
#pragma once

#include <cstdint>

namespace gibench {

/// A number's bits, each moved to twice its place.
constexpr std::uint64_t spread_bits(std::uint32_t x) {
  std::uint64_t bits = x;
  bits = (bits | (bits << 16)) & 0x0000ffff0000ffffULL;
  bits = (bits | (bits << 8)) & 0x00ff00ff00ff00ffULL;
  bits = (bits | (bits << 4)) & 0x0f0f0f0f0f0f0f0fULL;
  bits = (bits | (bits << 2)) & 0x3333333333333333ULL;
  return (bits | (bits << 1)) & 0x5555555555555555ULL;
}

/// The place on the curve of a cell in the plane; of two bits alike, that of `major` stands above that of `minor`.
constexpr std::uint64_t along_morton_curve(std::uint32_t major, std::uint32_t minor) {
  return spread_bits(major) << 1 | spread_bits(minor);
}

}  // namespace gibench
