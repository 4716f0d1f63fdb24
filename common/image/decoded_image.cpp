#include "common/image/decoded_image.h"

#include <algorithm>
#include <cmath>
#include <system_error>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/image/picture_format.h"
#include "common/image/png_check.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

std::optional<std::size_t> channel_named(const DecodedImage& image, const std::string& name) {
  const auto found = std::find(image.channels.begin(), image.channels.end(), name);
  if (found == image.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - image.channels.begin());
}

}  // namespace

DecodedImage decode_image(const std::filesystem::path& file) {
  std::error_code unreadable;
  if (!std::filesystem::is_regular_file(file, unreadable))
    throw InputError(file.string(), "no such image file", "name an EXR, HDR, PNG or JPEG file that exists");
  return decode_image(read_file(file), file.string());
}

DecodedImage decode_image(std::string_view bytes, const std::string& name) {
  DecodedImage decoded;
  const std::string format = picture_format(bytes, name);
  std::string failure = format.empty() ? "its first bytes are those of no format that is read" : png_damage(bytes);
  if (failure.empty()) failure = image_plugin().decode(bytes, format, decoded);
  if (!failure.empty())
    throw InputError(name, "cannot be read as an image (" + failure + ")", "give a whole EXR, HDR, PNG or JPEG file");
  return decoded;
}

std::optional<ColourChannels> colour_channels(const DecodedImage& image, const std::string& layer) {
  const std::string prefix = layer.empty() ? "" : layer + ".";
  const auto r = channel_named(image, prefix + "R"), g = channel_named(image, prefix + "G"),
             b = channel_named(image, prefix + "B");
  if (r && g && b) return ColourChannels{*r, *g, *b};
  if (const auto grey = channel_named(image, prefix + "Y")) return ColourChannels{*grey, *grey, *grey};
  return std::nullopt;
}

std::optional<std::size_t> alpha_channel(const DecodedImage& image) { return channel_named(image, "A"); }

Image linear_image(const DecodedImage& decoded, const ColourChannels& channels) {
  // Decoding the same few levels again and again is most of reading a picture: a table for 8 bits, a pow for the rest.
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

}  // namespace gibench
