/// FLIP: the difference that an observer sees when alternating between two pictures (Andersson, Nilsson, Akenine-Möller,
/// Oskarsson, Åström and Fairchild 2020, "FLIP: A Difference Evaluator for Alternating Images").
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/metrics/separable_filter.h"

namespace gibench {

/// A 0.7 m wide display of 3840 pixels seen from 0.7 m.
inline constexpr float default_pixels_per_degree = 67.0206F;

/// What FLIP takes from one picture, before two are compared.
struct FlipFeatures {
  Plane lightness, a, b;  ///< Hunt-adjusted L*a*b* of the picture filtered by the contrast sensitivity functions
  Plane edges, points;    ///< magnitudes of the first and second Gaussian derivatives of its luminance
};

/// `pixels`: linear, clamped to [0, 1]. pixels_per_degree > 0.
FlipFeatures flip_features(int width, int height, std::span<const Rgb> pixels, float pixels_per_degree);

/// The error of every pixel, in [0, 1].
std::vector<float> flip_differences(const FlipFeatures& reference, const FlipFeatures& test);

/// LDR-FLIP of two pictures of linear values, clamped to [0, 1].
std::vector<float> flip_map(int width, int height, std::span<const Rgb> reference, std::span<const Rgb> test,
                            float pixels_per_degree = default_pixels_per_degree);

/// Statistics of an error map. The quantiles are weighted by the errors themselves, as the authors propose: half of
/// the whole error is in pixels with an error over the weighted median.
struct FlipStatistics {
  double mean = 0.0, weighted_median = 0.0, quartile_1 = 0.0, quartile_3 = 0.0, min = 0.0, max = 0.0;
};
FlipStatistics flip_statistics(std::span<const float> errors);

}  // namespace gibench
