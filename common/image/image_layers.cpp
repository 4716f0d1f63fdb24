#include "common/image/image_layers.h"

#include <array>
#include <vector>

#include "common/core/error.h"
#include "common/image/image_plugin.h"

namespace gibench {
namespace {

/// Positions of the R, G and B of one layer among the file's channels; -1 where one is missing.
using LayerChannels = std::array<int, 3>;

std::map<std::string, LayerChannels> layers_of(const std::vector<std::string>& channels) {
  std::map<std::string, LayerChannels> layers;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const std::size_t dot = channels[i].rfind('.');
    const std::string layer = dot == std::string::npos ? "" : channels[i].substr(0, dot);
    const std::string channel = dot == std::string::npos ? channels[i] : channels[i].substr(dot + 1);
    const std::size_t position = std::string("RGB").find(channel);
    if (channel.size() != 1 || position == std::string::npos) continue;
    layers.try_emplace(layer, LayerChannels{-1, -1, -1}).first->second[position] = static_cast<int>(i);
  }
  std::erase_if(layers, [](const auto& layer) { return layer.second[0] < 0 || layer.second[1] < 0 || layer.second[2] < 0; });
  return layers;
}

Image layer_image(const DecodedImage& decoded, const LayerChannels& layer) {
  const std::size_t channels = decoded.channels.size();
  Image image{decoded.width, decoded.height, std::vector<Rgb>(decoded.samples.size() / channels)};
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    const float* pixel = decoded.samples.data() + i * channels;
    image.pixels[i] = Rgb{pixel[layer[0]], pixel[layer[1]], pixel[layer[2]]};
  }
  return image;
}

}  // namespace

std::map<std::string, Image> read_exr_layers(const std::filesystem::path& file) {
  DecodedImage decoded;
  if (const std::string failure = image_plugin().decode(file.string(), decoded); !failure.empty())
    throw InputError(file.string(), "cannot be read as an image (" + failure + ")", "give a whole EXR file");
  std::map<std::string, Image> images;
  for (const auto& [name, layer] : layers_of(decoded.channels)) images.emplace(name, layer_image(decoded, layer));
  return images;
}

}  // namespace gibench
