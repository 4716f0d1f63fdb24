/// Eight numbers side by side, in the compilers' own vectors: one AVX register, or what the machine has.
#pragma once

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#ifdef __AVX2__
#include <immintrin.h>
#else
#pragma GCC diagnostic ignored "-Wpsabi"  // nothing here is called across libraries
#endif

namespace gibench::antiradiance {

inline constexpr std::size_t lanes = 8;

using Float8 = float __attribute__((vector_size(4 * lanes)));
using Index8 = std::uint32_t __attribute__((vector_size(4 * lanes)));
using Mask8 = std::int32_t __attribute__((vector_size(4 * lanes)));  ///< all bits of a lane, or none

inline Float8 all(float x) { return Float8{} + x; }
inline Mask8 mask_of(bool every) { return Mask8{} - (every ? 1 : 0); }
/// The first `count`, of eight at most.
inline Mask8 first_lanes(std::size_t count) {
  return Index8{0, 1, 2, 3, 4, 5, 6, 7} < Index8{} + static_cast<std::uint32_t>(count);
}
inline float smaller(float a, float b) { return b < a ? b : a; }
inline Float8 smaller(const Float8& a, const Float8& b) { return b < a ? b : a; }
inline Float8 larger(const Float8& a, const Float8& b) { return a < b ? b : a; }
inline float larger(float a, float b) { return a < b ? b : a; }
inline Float8 magnitude(const Float8& x) { return std::bit_cast<Float8>(std::bit_cast<Index8>(x) & 0x7fffffffU); }

inline float square_root(float x) { return std::sqrt(x); }
inline Float8 square_root(const Float8& x) {
#ifdef __AVX2__
  return _mm256_sqrt_ps(x);
#else
  Float8 root{};
  for (std::size_t k = 0; k < lanes; ++k) root[k] = std::sqrt(x[k]);
  return root;
#endif
}

/// One bit a lane, the first the lowest.
inline unsigned bits_of(const Mask8& mask) {
#ifdef __AVX2__
  return static_cast<unsigned>(_mm256_movemask_ps(std::bit_cast<__m256>(mask)));
#else
  unsigned bits = 0;
  for (std::size_t k = 0; k < lanes; ++k) bits |= (mask[k] != 0 ? 1U : 0U) << k;
  return bits;
#endif
}

/// For every set of lanes: those of the set, in order, then others.
inline constexpr std::array<std::array<std::uint8_t, lanes>, 1U << lanes> lanes_of_set = [] {
  std::array<std::array<std::uint8_t, lanes>, 1U << lanes> result{};
  for (unsigned set = 0; set < result.size(); ++set) {
    std::size_t count = 0;
    for (std::uint8_t lane = 0; lane < lanes; ++lane)
      if ((set >> lane & 1U) != 0) result[set][count++] = lane;
  }
  return result;
}();

/// The lanes of a set side by side; what follows them is of no meaning.
template <class Vector>
Vector packed(const Vector& values, unsigned set) {
#ifdef __AVX2__
  std::int64_t packed_lanes = 0;
  std::memcpy(&packed_lanes, lanes_of_set[set].data(), lanes);
  const __m256i order = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128(packed_lanes));
  return std::bit_cast<Vector>(_mm256_permutevar8x32_epi32(std::bit_cast<__m256i>(values), order));
#else
  Vector result{};
  for (std::size_t k = 0; k < lanes; ++k) result[k] = values[lanes_of_set[set][k]];
  return result;
#endif
}

template <class Vector>
Vector load(const void* from) {
  Vector result;
  std::memcpy(&result, from, sizeof(result));
  return result;
}

template <class Vector>
void store(void* to, const Vector& values) {
  std::memcpy(to, &values, sizeof(values));
}

/// The four floats at byte `offset` of each of eight structures: four vectors, one of each float.
template <std::size_t offset, class Structure>
std::array<Float8, 4> load_quads(const Structure* base, const Index8& indices) {
  using Float4 = float __attribute__((vector_size(16)));
  std::array<Float8, 4> rows;  // of structures k and k + 4
  for (std::size_t k = 0; k < 4; ++k) {
    const auto low = load<Float4>(reinterpret_cast<const std::byte*>(base + indices[k]) + offset),
               high = load<Float4>(reinterpret_cast<const std::byte*>(base + indices[k + 4]) + offset);
    rows[k] = __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7);
  }
  const Float8 first = __builtin_shufflevector(rows[0], rows[1], 0, 8, 1, 9, 4, 12, 5, 13),
               second = __builtin_shufflevector(rows[2], rows[3], 0, 8, 1, 9, 4, 12, 5, 13),
               third = __builtin_shufflevector(rows[0], rows[1], 2, 10, 3, 11, 6, 14, 7, 15),
               fourth = __builtin_shufflevector(rows[2], rows[3], 2, 10, 3, 11, 6, 14, 7, 15);
  return {__builtin_shufflevector(first, second, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(first, second, 2, 3, 10, 11, 6, 7, 14, 15),
          __builtin_shufflevector(third, fourth, 0, 1, 8, 9, 4, 5, 12, 13),
          __builtin_shufflevector(third, fourth, 2, 3, 10, 11, 6, 7, 14, 15)};
}

}  // namespace gibench::antiradiance
