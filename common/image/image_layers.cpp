#include "common/image/image_layers.h"

#include "common/image/decoded_image.h"

namespace gibench {

std::map<std::string, Image> read_exr_layers(const std::filesystem::path& file) {
  const DecodedImage decoded = decode_image(file);
  std::map<std::string, Image> images;
  for (const std::string& channel : decoded.channels) {
    // Every layer with a red channel: "R" is the default one's, "direct.R" that of the layer "direct".
    const bool is_layer = channel.ends_with(".R");
    if (!is_layer && channel != "R") continue;
    const std::string layer = is_layer ? channel.substr(0, channel.size() - 2) : "";
    if (const auto channels = colour_channels(decoded, layer)) images.emplace(layer, linear_image(decoded, *channels));
  }
  return images;
}

}  // namespace gibench
