/// PNG pictures by libpng itself: OpenImageIO lets it write its errors and warnings to stderr.
#pragma once

#include <string>
#include <string_view>

#include "common/image/image_plugin.h"

namespace gibench {

/// All channels of a PNG's bytes; colours of a palette are looked up, transparent ones become alpha. Returns an empty text, or
/// libpng's words for what is wrong. `most_samples`: of a picture that is still read.
std::string decode_png(std::string_view bytes, std::int64_t most_samples, DecodedImage& image);

}  // namespace gibench
