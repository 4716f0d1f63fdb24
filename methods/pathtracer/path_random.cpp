#include "methods/pathtracer/path_random.h"

namespace gibench::pathtracer {

namespace {

// Plain loops over columns: nothing in them but arithmetic.

inline void put(std::uint32_t bits, float& number) { number = to_unit_float(bits); }
inline void put(std::uint32_t bits, std::uint32_t& number) { number = bits; }

template <bool stratified, class Number>
void draw(const std::uint64_t* keys, const std::uint32_t* indices, std::size_t count, std::uint32_t dimension,
          Number* __restrict x, Number* __restrict y) {
  for (std::size_t i = 0; i < count; ++i) {
    const SobolSequence sequence(keys[i]);
    const SobolPair pair = stratified ? sequence.pair(indices[i], dimension) : sequence.independent_pair(indices[i], dimension);
    put(pair.x, x[i]), put(pair.y, y[i]);
  }
}

template <class Number>
void draw(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension, Number* x,
          Number* y) {
  if (dimension.stratified()) draw<true>(keys.data(), indices.data(), keys.size(), dimension.number(), x, y);
  else draw<false>(keys.data(), indices.data(), keys.size(), dimension.number(), x, y);
}

}  // namespace

void draw_pairs(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension,
                std::span<float> x, std::span<float> y) {
  draw(keys, indices, dimension, x.data(), y.data());
}

void draw_pairs(std::span<const std::uint64_t> keys, std::span<const std::uint32_t> indices, Dimension dimension,
                std::span<std::uint32_t> x, std::span<std::uint32_t> y) {
  draw(keys, indices, dimension, x.data(), y.data());
}

}  // namespace gibench::pathtracer
