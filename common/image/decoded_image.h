/// From a file's channels to linear colours: what every reading of a picture goes through.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "common/image/image.h"
#include "common/image/image_plugin.h"

namespace gibench {

/// All channels of a file, of one part where it has several. InputError if it is missing, unreadable or truncated, or its
/// colours are stated in a way that is not read.
DecodedImage decode_image(const std::filesystem::path& file);
/// The same of a file's bytes. `name`: what messages call it; its ending decides where the bytes leave the format open.
DecodedImage decode_image(std::string_view bytes, const std::string& name);

/// Positions of red, green and blue among the channels; of grey three times.
using ColourChannels = std::array<std::size_t, 3>;

/// Those of the layer's R, G, B, else of its Y; empty where it has neither.
std::optional<ColourChannels> colour_channels(const DecodedImage& image, const std::string& layer);

/// Position of the alpha channel; empty where the picture has none.
std::optional<std::size_t> alpha_channel(const DecodedImage& image);

/// Floating-point samples as stored, integer ones decoded by the curve that the file states, or else from sRGB; colours of the
/// file's primaries become Rec. 709.
Image linear_image(const DecodedImage& decoded, const ColourChannels& channels);

}  // namespace gibench
