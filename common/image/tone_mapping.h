/// From linear radiance to what a display shows: an exposure in stops, a clamp to [0, 1], the sRGB curve. No other
/// curve: a preview must not hide the differences that it is looked at for.
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/image/image.h"

namespace gibench {

/// pixels × 2^stops, linear.
std::vector<Rgb> exposed(std::span<const Rgb> pixels, float stops);

/// sRGB-encoded values in [0, 1] of pixels × 2^stops, clamped.
std::vector<Rgb> display_values(std::span<const Rgb> pixels, float stops);

/// The picture that write_png shows at this exposure: linear, not yet clamped.
Image exposed(const Image& image, float stops);

}  // namespace gibench
