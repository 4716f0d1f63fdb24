/// Owen-scrambled Sobol points by hashing: padded two-dimensional (0,2)-sequences, each with its own shuffle and
/// scramble. Burley 2020, "Practical Hash-based Owen Scrambling", JCGT 9(4).
#pragma once

#include <cstdint>

#include "common/core/random.h"
#include "common/core/vec.h"

namespace gibench {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = (x >> 16) | (x << 16);
  x = ((x & 0xff00ff00U) >> 8) | ((x & 0x00ff00ffU) << 8);
  x = ((x & 0xf0f0f0f0U) >> 4) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x & 0xccccccccU) >> 2) | ((x & 0x33333333U) << 2);
  return ((x & 0xaaaaaaaaU) >> 1) | ((x & 0x55555555U) << 1);
}

/// Owen scramble of a number given with its bits reversed: every bit is flipped by a hash of the bits below it alone
/// (Laine and Karras 2011, with the constants of Vegdahl 2021).
constexpr std::uint32_t owen_scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

/// The second Sobol dimension of `index`, bits reversed. Its generator is the Pascal matrix modulo 2, whose product
/// with a vector of bits is a sum over supersets of bit positions (Lucas): five shifts instead of 32 columns.
constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
  index ^= (index >> 1) & 0x55555555U;
  index ^= (index >> 2) & 0x33333333U;
  index ^= (index >> 4) & 0x0f0f0f0fU;
  index ^= (index >> 8) & 0x00ff00ffU;
  return index ^ ((index >> 16) & 0x0000ffffU);
}

/// Two coordinates as 32-bit fractions of one.
struct SobolPair {
  std::uint32_t x, y;
  /// In [0, 1)².
  Vec2 unit() const { return {to_unit_float(x), to_unit_float(y)}; }
};

/// One replicate: a progressive sequence of points of any number of dimension pairs. Two keys give independent
/// sequences; so do two pairs of one key. Every aligned run of 2^k points of a pair is a (0, k, 2)-net.
class SobolSequence {
 public:
  constexpr explicit SobolSequence(std::uint64_t key) : key_(key) {}

  constexpr SobolPair pair(std::uint32_t index, std::uint32_t dimension_pair) const {
    const std::uint64_t scramble = mix_keys(key_, dimension_pair);
    const std::uint64_t shuffle = mix_bits(scramble + 0x9e3779b97f4a7c15ULL);
    const std::uint32_t shuffled = reverse_bits(owen_scramble_reversed(reverse_bits(index), static_cast<std::uint32_t>(shuffle)));
    // The first dimension is the reversed index: reversed again, the index itself.
    const std::uint32_t x = owen_scramble_reversed(shuffled, static_cast<std::uint32_t>(scramble));
    const std::uint32_t y = owen_scramble_reversed(sobol_second_reversed(shuffled), static_cast<std::uint32_t>(scramble >> 32));
    return {reverse_bits(x), reverse_bits(y)};
  }

  /// Independent uniform numbers of the same keys, for dimensions so deep that stratification has nothing left to give.
  constexpr SobolPair independent_pair(std::uint32_t index, std::uint32_t dimension_pair) const {
    const std::uint64_t bits = mix_keys(key_, (std::uint64_t{index} << 32) | dimension_pair);
    return {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32)};
  }

 private:
  std::uint64_t key_;
};

}  // namespace gibench
