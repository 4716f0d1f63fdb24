/// The random numbers of paths, keyed by (seed, value, replicate, path, reflection, use).
#pragma once

#include <cstdint>
#include <span>

#include "common/core/sobol.h"
#include "common/lighting/light_group.h"

namespace gibench::pathtracer {

/// What a pair of numbers is for; those for light samples follow, one for each group of lights and sample.
enum class Use : std::uint32_t { direction, lobe_and_roulette, out, lobe_class, first_of_lights };

/// A pair of dimensions of the sequences.
class Dimension {
 public:
  constexpr Dimension(int reflection, Use use) : Dimension(reflection, static_cast<std::uint32_t>(use)) {}
  constexpr Dimension(int reflection, LightGroup group, std::uint32_t light_sample)
      : Dimension(reflection, static_cast<std::uint32_t>(Use::first_of_lights) + light_sample * most_light_groups +
                                  static_cast<std::uint32_t>(group)) {}

  constexpr std::uint32_t number() const { return number_; }
  constexpr bool stratified() const { return stratified_; }

 private:
  static constexpr std::uint32_t pairs_per_vertex = 512;  // more than the uses and 64 samples of each group of lights take
  static constexpr int stratified_reflections = 6;        // deeper, many dimensions are mixed into each value

  constexpr Dimension(int reflection, std::uint32_t use)
      : number_(static_cast<std::uint32_t>(reflection) * pairs_per_vertex + use),
        stratified_(reflection < stratified_reflections) {}

  std::uint32_t number_;
  bool stratified_;
};

/// A path's place in the sequence of its replicate.
struct PathRandom {
  std::uint64_t key = 0;  ///< of the replicate
  std::uint32_t index = 0;

  SobolPair pair(Dimension dimension) const {
    const SobolSequence sequence(key);
    return dimension.stratified() ? sequence.pair(index, dimension.number())
                                  : sequence.independent_pair(index, dimension.number());
  }
};

/// The pairs of many paths, column by column, which the compiler turns into vectors. All columns are of one length.
void draw_pairs(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension,
                std::span<float> x, std::span<float> y);
/// The same as 32-bit fractions of one.
void draw_pairs(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension,
                std::span<std::uint32_t> x, std::span<std::uint32_t> y);

}  // namespace gibench::pathtracer
