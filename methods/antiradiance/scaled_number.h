/// Numbers of 16 bits, as multiples of a unit that a row of them shares.
#pragma once

#include <cstdint>
#include <cstring>

namespace gibench::antiradiance {

using ScaledNumber = std::int16_t;
inline constexpr float most_units = 32767.0F;

/// Four numbers of 32 bits from four of 16 side by side, in units.
using FourFloats = float __attribute__((vector_size(16)));
inline FourFloats load_four(const ScaledNumber* from) {
  using FourNumbers = ScaledNumber __attribute__((vector_size(8)));
  FourNumbers numbers;
  std::memcpy(&numbers, from, sizeof(numbers));
  return __builtin_convertvector(numbers, FourFloats);
}

}  // namespace gibench::antiradiance
