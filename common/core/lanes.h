/// Eight numbers side by side, in the compilers' own vectors: one AVX register, or what the machine has.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#ifdef __AVX__
#include <immintrin.h>
#else
#pragma GCC diagnostic ignored "-Wpsabi"  // nothing here is called across libraries
#endif

namespace gibench {

inline constexpr std::size_t lane_count = 8;

using Lanes = float __attribute__((vector_size(4 * lane_count)));  ///< operators work lane by lane
using IndexLanes = std::uint32_t __attribute__((vector_size(4 * lane_count)));
/// All bits of a lane or none, as comparisons give it.
using LaneMask = std::int32_t __attribute__((vector_size(4 * lane_count)));

inline Lanes all_lanes(float x) { return Lanes{x, x, x, x, x, x, x, x}; }
inline LaneMask mask_of(bool every) { return LaneMask{} - (every ? 1 : 0); }
/// The first `count`, of eight at most.
inline LaneMask first_lanes(std::size_t count) {
  return IndexLanes{0, 1, 2, 3, 4, 5, 6, 7} < IndexLanes{} + static_cast<std::uint32_t>(count);
}

// Where neither is smaller, the first: of equal zeros, and where one is not a number, as std::min and std::max have it.
inline float smaller(float a, float b) { return b < a ? b : a; }
inline Lanes smaller(const Lanes& a, const Lanes& b) { return b < a ? b : a; }
inline float larger(float a, float b) { return a < b ? b : a; }
inline Lanes larger(const Lanes& a, const Lanes& b) { return a < b ? b : a; }
inline Lanes magnitude(const Lanes& x) { return std::bit_cast<Lanes>(std::bit_cast<IndexLanes>(x) & 0x7fffffffU); }

inline float square_root(float x) { return std::sqrt(x); }
/// The lanes must not be negative.
inline Lanes square_root(const Lanes& x) {
#ifdef __AVX__
  return _mm256_sqrt_ps(x);
#else
  Lanes root{};
  for (std::size_t k = 0; k < lane_count; ++k) root[k] = std::sqrt(x[k]);
  return root;
#endif
}

/// One bit a lane, the first the lowest.
inline std::uint32_t lane_bits(const LaneMask& mask) {
#ifdef __AVX__
  return static_cast<std::uint32_t>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
#else
  std::uint32_t bits = 0;
  for (std::size_t k = 0; k < lane_count; ++k) bits |= (mask[k] != 0 ? 1U : 0U) << k;
  return bits;
#endif
}

/// The sum of the lanes, always in the same order.
inline float sum_of(const Lanes& a) { return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7])); }

/// For every set of lanes: those of the set, in order, then others.
inline constexpr std::array<std::array<std::uint8_t, lane_count>, 1U << lane_count> lanes_of_set = [] {
  std::array<std::array<std::uint8_t, lane_count>, 1U << lane_count> result{};
  for (unsigned set = 0; set < result.size(); ++set) {
    std::size_t count = 0;
    for (std::uint8_t lane = 0; lane < lane_count; ++lane)
      if ((set >> lane & 1U) != 0) result[set][count++] = lane;
  }
  return result;
}();

/// The lanes of a set side by side; what follows them is of no meaning.
template <class Vector>
Vector packed_lanes(const Vector& values, unsigned set) {
#ifdef __AVX2__
  std::int64_t in_order = 0;
  std::memcpy(&in_order, lanes_of_set[set].data(), lane_count);
  const __m256i order = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(in_order));
  return std::bit_cast<Vector>(_mm256_permutevar8x32_epi32(std::bit_cast<__m256i>(values), order));
#else
  Vector result{};
  for (std::size_t k = 0; k < lane_count; ++k) result[k] = values[lanes_of_set[set][k]];
  return result;
#endif
}

/// From any address, aligned or not.
template <class Vector>
Vector load_lanes(const void* from) {
  Vector result;
  std::memcpy(&result, from, sizeof(result));
  return result;
}

/// Eight numbers as floats.
inline Lanes load_numbers(const float* from) { return load_lanes<Lanes>(from); }
inline Lanes load_numbers(const std::int16_t* from) {
  using ShortLanes = std::int16_t __attribute__((vector_size(2 * lane_count)));
  return __builtin_convertvector(__builtin_convertvector(load_lanes<ShortLanes>(from), LaneMask), Lanes);
}

template <class Vector>
void store_lanes(void* to, const Vector& values) {
  std::memcpy(to, &values, sizeof(values));
}

/// The four floats at byte `offset` of each of eight structures: four vectors, one of each float.
template <std::size_t offset, class Structure>
std::array<Lanes, 4> load_quads(const Structure* base, const IndexLanes& indices) {
  using Float4 = float __attribute__((vector_size(16)));
  std::array<Lanes, 4> rows;  // of structures k and k + 4
  for (std::size_t k = 0; k < 4; ++k) {
    const auto low = load_lanes<Float4>(reinterpret_cast<const std::byte*>(base + indices[k]) + offset),
               high = load_lanes<Float4>(reinterpret_cast<const std::byte*>(base + indices[k + 4]) + offset);
    rows[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  const Lanes first = __builtin_shufflevector(rows[0], rows[1], 0, 8, 1, 9, 4, 12, 5, 13),
              second = __builtin_shufflevector(rows[2], rows[3], 0, 8, 1, 9, 4, 12, 5, 13),
              third = __builtin_shufflevector(rows[0], rows[1], 2, 10, 3, 11, 6, 14, 7, 15),
              fourth = __builtin_shufflevector(rows[2], rows[3], 2, 10, 3, 11, 6, 14, 7, 15);
  return {__builtin_shufflevector(first, second, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(first, second, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(third, fourth, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(third, fourth, 2, 3, 10, 11, 6, 7, 14, 15)};
}

}  // namespace gibench
