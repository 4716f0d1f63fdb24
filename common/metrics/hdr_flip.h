/// HDR-FLIP: LDR-FLIP at a range of exposures, the largest error of each pixel (Andersson, Nilsson, Shirley and
/// Akenine-Möller 2021, "Visualizing Errors in Rendered High Dynamic Range Images").
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/metrics/flip.h"

namespace gibench {

/// The curve that maps exposed radiance to [0, 1].
enum class ToneMapper { aces, reinhard, hable };

/// `count` exposures in equal steps from start to stop, in stops.
struct ExposureRange {
  float start = 0.0F, stop = 0.0F;
  int count = 2;
  std::vector<float> exposures() const;
};

/// start … stop with the paper's number of exposures, max(2, ⌈stop − start⌉).
ExposureRange exposure_range(float start, float stop);

/// The range of the paper's section 4: from the exposure that takes the reference's largest luminance to 0.85 of the tone
/// mapper's range to the one that takes its median there. Where more than half of the picture is black the median is of
/// the rest; a black picture has the range 0 … 0.
ExposureRange automatic_exposures(std::span<const Rgb> reference, ToneMapper tone_mapper = ToneMapper::aces);

/// The tone-mapped picture at an exposure, linear, in [0, 1]; negative values count as 0.
std::vector<Rgb> tone_mapped(std::span<const Rgb> pixels, float exposure, ToneMapper tone_mapper);

/// HDR-FLIP of two pictures of linear values: the error of every pixel, in [0, 1].
std::vector<float> hdr_flip_map(int width, int height, std::span<const Rgb> reference, std::span<const Rgb> test,
                                const ExposureRange& range, ToneMapper tone_mapper = ToneMapper::aces,
                                float pixels_per_degree = default_pixels_per_degree);

}  // namespace gibench
