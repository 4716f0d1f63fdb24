#include "common/image/tone_mapping.h"

#include <cmath>

#include "common/core/parallel.h"
#include "common/image/srgb.h"

namespace gibench {

std::vector<Rgb> exposed(std::span<const Rgb> pixels, float stops) {
  const float scale = std::exp2(stops);
  std::vector<Rgb> scaled(pixels.begin(), pixels.end());
  for (Rgb& pixel : scaled) pixel *= scale;
  return scaled;
}

std::vector<Rgb> display_values(std::span<const Rgb> pixels, float stops) {
  const float scale = std::exp2(stops);
  std::vector<Rgb> encoded(pixels.size());
  parallel_chunks(0, pixels.size(), 16384, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) encoded[i] = linear_to_srgb(clamp_unit(scale * pixels[i]));
  });
  return encoded;
}

Image exposed(const Image& image, float stops) { return {image.width, image.height, exposed(image.pixels, stops)}; }

}  // namespace gibench
