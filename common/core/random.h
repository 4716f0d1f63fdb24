/// Random numbers keyed by (seed, stage, index), never by thread: the same seed gives the same bits for any
/// number of threads.
#pragma once

#include <cstdint>

namespace gibench {

/// Bijective 64-bit mixer (splitmix64 finaliser, Steele et al. 2014).
constexpr std::uint64_t mix_bits(std::uint64_t x) {
  x ^= x >> 30;
  x *= 0xbf58476d1ce4e5b9ULL;
  x ^= x >> 27;
  x *= 0x94d049bb133111ebULL;
  return x ^ (x >> 31);
}

/// One key out of several; order matters.
constexpr std::uint64_t mix_keys(std::uint64_t a, std::uint64_t b) { return mix_bits(mix_bits(a + 0x9e3779b97f4a7c15ULL) ^ b); }
constexpr std::uint64_t mix_keys(std::uint64_t a, std::uint64_t b, std::uint64_t c) { return mix_keys(mix_keys(a, b), c); }

/// Uniform in [0, 1) with 24 bits, exact in float.
constexpr float to_unit_float(std::uint32_t bits) { return static_cast<float>(bits >> 8) * 0x1p-24F; }

/// splitmix64 stream of one (seed, stage, index); cheap to make, so make one per item of a loop.
class RandomStream {
 public:
  constexpr RandomStream(std::uint64_t seed, std::uint64_t stage, std::uint64_t index) : state_(mix_keys(seed, stage, index)) {}
  constexpr std::uint64_t next_bits() { return mix_bits(state_ += 0x9e3779b97f4a7c15ULL); }
  /// Uniform in [0, 1).
  constexpr float next_float() { return to_unit_float(static_cast<std::uint32_t>(next_bits() >> 32)); }
  /// Uniform in [0, 1) with 53 bits.
  constexpr double next_double() { return static_cast<double>(next_bits() >> 11) * 0x1p-53; }

 private:
  std::uint64_t state_;
};

}  // namespace gibench
