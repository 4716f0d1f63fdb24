/// False colours for error maps, readable with every kind of colour vision, because lightness alone carries the value.
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/image/image.h"

namespace gibench {

/// The viridis colours of Smith and van der Walt (2015), perceptually uniform: dark violet at 0, yellow at 1; values
/// outside are clamped, a NaN is shown as 0. Linear RGB, as write_png expects.
Rgb viridis(float value);

/// One colour for each value; `low` and `high` are the ends of the scale (high > low).
Image heat_map(int width, int height, std::span<const float> values, float low, float high);

/// Per pixel |x − r| / (|r| + 0.01 M), averaged over the channels, M the mean of r: what mape(0.01) is the mean of. 0 for a black
/// reference.
std::vector<float> relative_error_map(std::span<const Rgb> pixels, std::span<const Rgb> reference);

}  // namespace gibench
