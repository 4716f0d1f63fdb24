#include "common/image/image.h"

#include <algorithm>
#include <array>
#include <optional>
#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/image/image_plugin.h"
#include "common/image/png_check.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

using ChannelTriple = std::array<std::size_t, 3>;

std::optional<std::size_t> channel_named(const DecodedImage& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  if (found == image.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - image.channels.begin());
}

/// Where the colours of `layer` are: R, G, B, or a grey Y three times.
std::optional<ChannelTriple> colour_channels(const DecodedImage& image, const std::string& layer) {
  const std::string prefix = layer.empty() ? "" : layer + ".";
  const auto r = channel_named(image, prefix + "R"), g = channel_named(image, prefix + "G"),
             b = channel_named(image, prefix + "B");
  if (r && g && b) return ChannelTriple{*r, *g, *b};
  if (const auto grey = channel_named(image, prefix + "Y")) return ChannelTriple{*grey, *grey, *grey};
  return std::nullopt;
}

/// Decoding the same few levels again and again is most of reading a picture: a table for 8 bits, a pow for the rest.
Image to_linear(const DecodedImage& decoded, const ChannelTriple& channels) {
  std::array<float, 256> table;
  for (std::size_t i = 0; i < table.size(); ++i) table[i] = srgb_to_linear(static_cast<float>(i) / 255.0F);
  const auto value_of = [&](float sample) {
    if (!decoded.integer_samples) return sample;
    const float level = sample * 255.0F;
    const float nearest = std::nearbyint(level);
    return std::abs(level - nearest) < 1e-4F ? table[static_cast<std::size_t>(nearest)] : srgb_to_linear(sample);
  };
  Image image{decoded.width, decoded.height, {}};
  const std::size_t stride = decoded.channels.size();
  image.pixels.resize(decoded.samples.size() / stride);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* const pixel = decoded.samples.data() + i * stride;
    image.pixels[i] = {value_of(pixel[channels[0]]), value_of(pixel[channels[1]]), value_of(pixel[channels[2]])};
  }
  return image;
}

void check_shape(int width, int height, std::size_t pixels) {
  GIBENCH_CHECK(width > 0 && height > 0, "a picture has pixels");
  GIBENCH_CHECK(pixels == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "one value for each pixel");
}

void check_encoded(const std::filesystem::path& file, const std::string& failure) {
  if (!failure.empty()) throw InputError(file.string(), "cannot be encoded (" + failure + ")");
}

}  // namespace

ImageFile read_image_file(const std::filesystem::path& file, const std::string& layer) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable))
    throw InputError(file.string(), "no such image file", "name an EXR, HDR, PNG or JPEG file that exists");
  DecodedImage decoded;
  std::string failure = png_damage(read_file(file));
  if (failure.empty()) failure = image_plugin().decode(file.string(), decoded);
  if (!failure.empty())
    throw InputError(file.string(), "cannot be read as an image (" + failure + ")", "give a whole EXR, HDR, PNG or JPEG file");
  const std::optional<ChannelTriple> channels = colour_channels(decoded, layer);
  if (!channels)
    throw InputError(file.string(), layer.empty() ? "has neither R, G, B nor Y channels" : "has no layer \"" + layer + "\"",
                     "give a picture with colour or grey channels of that name");
  return {to_linear(decoded, *channels), !decoded.integer_samples, std::move(decoded.header)};
}

Image read_image(const std::filesystem::path& file) { return read_image_file(file).image; }

void write_exr(const std::filesystem::path& file, int width, int height, std::span<const ImageLayer> layers,
               std::span<const std::pair<std::string, std::string>> header) {
  static_assert(sizeof(Rgb) == 3 * sizeof(float), "channels are taken with a stride of three floats");
  GIBENCH_CHECK(!layers.empty(), "an EXR has a layer");
  std::vector<EncodedChannel> channels;
  for (const ImageLayer& layer : layers) {
    check_shape(width, height, layer.pixels.size());
    const std::string prefix = layer.name.empty() ? "" : layer.name + ".";
    const Rgb& first = layer.pixels.front();
    channels.push_back({prefix + "R", &first.r, 3});
    channels.push_back({prefix + "G", &first.g, 3});
    channels.push_back({prefix + "B", &first.b, 3});
  }
  std::vector<char> bytes;
  check_encoded(file, image_plugin().encode_exr(width, height, channels, header, bytes));
  write_file_atomically(file, bytes);
}

void write_png(const std::filesystem::path& file, const Image& image) {
  check_shape(image.width, image.height, image.pixels.size());
  std::vector<std::uint8_t> levels;
  levels.reserve(3 * image.pixels.size());
  for (const Rgb& pixel : image.pixels)
    for (int channel = 0; channel < 3; ++channel) levels.push_back(srgb_byte(pixel[channel]));
  std::vector<char> bytes;
  check_encoded(file, image_plugin().encode_png(image.width, image.height, levels, bytes));
  write_file_atomically(file, bytes);
}

}  // namespace gibench
