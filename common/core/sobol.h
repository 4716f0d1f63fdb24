/// Owen-scrambled Sobol points: independent replicates by seed, progressive in the index.
///
/// Burley 2020, "Practical Hash-based Owen Scrambling": the first two Sobol dimensions, a (0,2)-sequence, are
/// padded to as many pairs of dimensions as asked for; each pair shuffles the index and scrambles both
/// coordinates with a seed of its own, so that every pair is stratified and pairs are independent.
#pragma once

#include <cstdint>

#include "common/core/random.h"
#include "common/core/vec.h"

namespace gibench {

constexpr std::uint32_t reverse_bits(std::uint32_t x) {
  x = __builtin_bswap32(x);
  x = ((x >> 4) & 0x0f0f0f0fU) | ((x & 0x0f0f0f0fU) << 4);
  x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
  return ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
}

/// Laine–Karras permutation with Burley's constants: an Owen scramble of the bit-reversed argument.
constexpr std::uint32_t scramble_reversed(std::uint32_t x, std::uint32_t seed) {
  x ^= x * 0x3d20adeaU;
  x += seed;
  x *= (seed >> 16) | 1U;
  x ^= x * 0x05526c56U;
  x ^= x * 0x53a22864U;
  return x;
}

/// Bit-reversed second Sobol coordinate of an index: bit j is the parity of the index bits k with C(k, j) odd,
/// that is (Lucas) of all k whose binary digits contain j's: a sum over supersets in five steps.
constexpr std::uint32_t sobol_second_reversed(std::uint32_t index) {
  index ^= (index >> 1) & 0x55555555U;
  index ^= (index >> 2) & 0x33333333U;
  index ^= (index >> 4) & 0x0f0f0f0fU;
  index ^= (index >> 8) & 0x00ff00ffU;
  return index ^ ((index >> 16) & 0x0000ffffU);
}

/// Point `index` of the pair of dimensions that `seed` stands for, in [0, 1)².
constexpr Vec2 sobol_point(std::uint32_t index, std::uint64_t seed) {
  const auto low = static_cast<std::uint32_t>(seed);
  const auto high = static_cast<std::uint32_t>(seed >> 32);
  const std::uint32_t shuffled = reverse_bits(scramble_reversed(reverse_bits(index), low));
  const std::uint32_t x = reverse_bits(scramble_reversed(shuffled, high));
  const std::uint32_t y =
      reverse_bits(scramble_reversed(sobol_second_reversed(shuffled), high ^ (low * 0x9e3779b9U) ^ 0x68bc21ebU));
  return {to_unit_float(x), to_unit_float(y)};
}

/// The random numbers of one sample of one value: stratified pairs first, independent ones for the deep end of a
/// path, where stratification no longer helps.
class SobolSampler {
 public:
  constexpr SobolSampler(std::uint64_t seed, std::uint32_t index) : seed_(seed), index_(index), tail_(seed, tail_stage, index) {}

  constexpr Vec2 next_pair() {
    if (pair_ >= stratified_pairs) {
      const std::uint64_t bits = tail_.next_bits();
      return {to_unit_float(static_cast<std::uint32_t>(bits)), to_unit_float(static_cast<std::uint32_t>(bits >> 32))};
    }
    return sobol_point(index_, mix_keys(seed_, pair_++));
  }

 private:
  static constexpr std::uint64_t stratified_pairs = 12;
  static constexpr std::uint64_t tail_stage = 0x7461696cULL;
  std::uint64_t seed_;
  std::uint32_t index_;
  std::uint64_t pair_ = 0;
  RandomStream tail_;
};

}  // namespace gibench
