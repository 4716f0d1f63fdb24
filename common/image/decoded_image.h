/// From a file's channels to linear colours: what every reading of a picture goes through.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

#include "common/image/image.h"
#include "common/image/image_plugin.h"

namespace gibench {

/// All channels of a file. InputError if it is missing, unreadable or truncated.
DecodedImage decode_image(const std::filesystem::path& file);

/// Positions of red, green and blue among the channels; of grey three times.
using ColourChannels = std::array<std::size_t, 3>;

/// Those of the layer's R, G, B, else of its Y; empty where it has neither.
std::optional<ColourChannels> colour_channels(const DecodedImage& image, const std::string& layer);

/// Floating-point samples as stored, integer ones decoded from sRGB.
Image linear_image(const DecodedImage& decoded, const ColourChannels& channels);

}  // namespace gibench
