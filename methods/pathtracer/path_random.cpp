#include "methods/pathtracer/path_random.h"

namespace gibench::pathtracer {

namespace {

// Plain loops over columns: nothing in them but arithmetic.

template <bool stratified>
void draw(const std::uint64_t* keys, const std::uint32_t* indices, std::size_t count, std::uint32_t dimension,
          float* __restrict x, float* __restrict y) {
  for (std::size_t i = 0; i < count; ++i) {
    const SobolSequence sequence(keys[i]);
    const SobolPair pair = stratified ? sequence.pair(indices[i], dimension) : sequence.independent_pair(indices[i], dimension);
    x[i] = to_unit_float(pair.x), y[i] = to_unit_float(pair.y);
  }
}

template <bool stratified>
void draw(const std::uint64_t* keys, const std::uint32_t* indices, std::size_t count, std::uint32_t dimension,
          std::uint32_t* __restrict x) {
  for (std::size_t i = 0; i < count; ++i) {
    const SobolSequence sequence(keys[i]);
    x[i] = stratified ? sequence.pair(indices[i], dimension).x : sequence.independent_pair(indices[i], dimension).x;
  }
}

}  // namespace

void draw_pairs(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension,
                std::span<float> x, std::span<float> y) {
  if (dimension.stratified()) draw<true>(keys.data(), indices.data(), keys.size(), dimension.number(), x.data(), y.data());
  else draw<false>(keys.data(), indices.data(), keys.size(), dimension.number(), x.data(), y.data());
}

void draw_fractions(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension,
                    std::span<std::uint32_t> x) {
  if (dimension.stratified()) draw<true>(keys.data(), indices.data(), keys.size(), dimension.number(), x.data());
  else draw<false>(keys.data(), indices.data(), keys.size(), dimension.number(), x.data());
}

}  // namespace gibench::pathtracer
