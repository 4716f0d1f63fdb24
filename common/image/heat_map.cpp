#include "common/image/heat_map.h"

#include <array>
#include <cmath>
#include <cstdint>

#include "common/core/error.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

/// sRGB, every eighth of viridis' 256 colours; linear interpolation between them is right to 2 levels of 255.
constexpr std::array<std::uint32_t, 33> stops{
    0x440154, 0x470d60, 0x48186a, 0x482374, 0x472d7b, 0x453781, 0x424086, 0x3e4989, 0x3b528b, 0x375b8d, 0x33638d,
    0x2f6b8e, 0x2c728e, 0x297a8e, 0x26828e, 0x23898e, 0x21918c, 0x1f978b, 0x1f9f88, 0x21a685, 0x27ad81, 0x31b57b,
    0x3dbc74, 0x4cc26c, 0x5cc863, 0x6ece58, 0x81d34d, 0x95d840, 0xaadc32, 0xc0df25, 0xd5e21a, 0xeae51a, 0xfde725};

Rgb stop_colour(std::size_t i) {
  const auto level = [&](int shift) { return static_cast<float>(stops[i] >> shift & 0xffU) / 255.0F; };
  return {level(16), level(8), level(0)};
}

}  // namespace

Rgb viridis(float value) {
  const float place = clamp_unit(value) * static_cast<float>(stops.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), stops.size() - 2);
  const float share = place - static_cast<float>(below);
  return srgb_to_linear((1.0F - share) * stop_colour(below) + share * stop_colour(below + 1));
}

Image heat_map(int width, int height, std::span<const float> values, float low, float high) {
  GIBENCH_CHECK(values.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "one value for each pixel");
  GIBENCH_CHECK(high > low, "the scale has a length");
  Image image{width, height, {}};
  image.pixels.reserve(values.size());
  for (const float value : values) image.pixels.push_back(viridis((value - low) / (high - low)));
  return image;
}

std::vector<float> relative_error_map(std::span<const Rgb> pixels, std::span<const Rgb> reference) {
  GIBENCH_CHECK(pixels.size() == reference.size(), "one reference value for each pixel");
  std::vector<float> errors(pixels.size());
  RgbDouble total;
  for (const Rgb& value : reference) total += RgbDouble(value);
  const auto mean = static_cast<float>((total.r + total.g + total.b) / (3.0 * static_cast<double>(reference.size())));
  if (!(mean > 0.0F)) return errors;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    float sum = 0.0F;
    for (int c = 0; c < 3; ++c) sum += std::abs(pixels[i][c] - reference[i][c]) / (std::abs(reference[i][c]) + 0.01F * mean);
    errors[i] = sum / 3.0F;
  }
  return errors;
}

}  // namespace gibench
