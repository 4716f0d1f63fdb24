/// Eight floats side by side: the compiler's vector type, and the two operations that it has no spelling for.
#pragma once

#include <cmath>
#include <cstdint>

#ifdef __AVX__
#include <immintrin.h>
#endif

namespace gibench::meshless {

inline constexpr std::uint32_t lane_count = 8;

using Lanes = float __attribute__((vector_size(32)));            ///< operators work lane by lane
using LaneMask = std::int32_t __attribute__((vector_size(32)));  ///< -1 or 0 in each lane, as comparisons give it

inline Lanes all_lanes(float value) { return Lanes{value, value, value, value, value, value, value, value}; }

inline Lanes smaller(const Lanes& a, const Lanes& b) { return a < b ? a : b; }
inline Lanes larger(const Lanes& a, const Lanes& b) { return a > b ? a : b; }

/// Square roots; the lanes must not be negative.
inline Lanes square_root(const Lanes& a) {
#ifdef __AVX__
  return _mm256_sqrt_ps(a);
#else
  Lanes root;
  for (std::uint32_t i = 0; i < lane_count; ++i) root[i] = std::sqrt(a[i]);
  return root;
#endif
}

/// Bit i is set where lane i of the mask is.
inline std::uint32_t lane_bits(const LaneMask& mask) {
#ifdef __AVX__
  return static_cast<std::uint32_t>(_mm256_movemask_ps(reinterpret_cast<__m256>(mask)));
#else
  std::uint32_t bits = 0;
  for (std::uint32_t i = 0; i < lane_count; ++i) bits |= mask[i] != 0 ? 1U << i : 0U;
  return bits;
#endif
}

/// The sum of the lanes, always in the same order.
inline float sum_of(const Lanes& a) { return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7])); }

}  // namespace gibench::meshless
