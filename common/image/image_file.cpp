#include "common/image/image_file.h"

#include <optional>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/image/decoded_image.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

void check_shape(int width, int height, std::size_t pixels) {
  GIBENCH_CHECK(width > 0 && height > 0, "a picture has pixels");
  GIBENCH_CHECK(pixels == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "one value for each pixel");
}

void check_encoded(const std::filesystem::path& file, const std::string& failure) {
  if (!failure.empty()) throw InputError(file.string(), "cannot be encoded (" + failure + ")");
}

}  // namespace

ImageFile read_image_file(const std::filesystem::path& file, const std::string& layer) {
  DecodedImage decoded = decode_image(file);
  const std::optional<ColourChannels> channels = colour_channels(decoded, layer);
  if (!channels)
    throw InputError(file.string(), layer.empty() ? "has neither R, G, B nor Y channels" : "has no layer \"" + layer + "\"",
                     "give a picture with colour or grey channels of that name");
  std::vector<std::string> warnings = std::move(decoded.remarks);
  warnings.insert(warnings.end(), decoded.colour_remarks.begin(), decoded.colour_remarks.end());
  return {linear_image(decoded, *channels), !decoded.integer_samples, std::move(decoded.header), std::move(warnings)};
}

bool ImageFile::is_cube_map() const {
  const auto format = header.find("textureformat");  // OpenImageIO's word for an EXR's attribute "envmap"
  return format != header.end() && format->second.starts_with("CubeFace");
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
