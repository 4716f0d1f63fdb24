#include "common/image/tone_mapping.h"

#include <algorithm>
#include <cmath>

#include "common/core/parallel.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

/// In double: the exposure of the largest floats is less than a float holds.
class Exposing {
 public:
  explicit Exposing(float stops) : scale_(std::exp2(static_cast<double>(stops))) {}

  Rgb operator()(const Rgb& pixel) const { return Rgb(scale_ * RgbDouble(pixel)); }

 private:
  double scale_;
};

}  // namespace

std::vector<Rgb> exposed(std::span<const Rgb> pixels, float stops) {
  std::vector<Rgb> scaled(pixels.size());
  std::ranges::transform(pixels, scaled.begin(), Exposing(stops));
  return scaled;
}

std::vector<Rgb> display_values(std::span<const Rgb> pixels, float stops) {
  const Exposing expose(stops);
  std::vector<Rgb> encoded(pixels.size());
  parallel_chunks(0, pixels.size(), 16384, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) encoded[i] = linear_to_srgb(clamp_unit(expose(pixels[i])));
  });
  return encoded;
}

Image exposed(const Image& image, float stops) { return {image.width, image.height, exposed(image.pixels, stops)}; }

}  // namespace gibench
