/// The one-dimensional filters of FLIP; each two-dimensional one is a product of two of them, or a sum of products.
#pragma once

#include <vector>

namespace gibench {

/// Contrast sensitivity of the eye per opponent channel (paper, section 4.1, table 1), as filters in space. Blue-yellow
/// is the sum of two Gaussians.
struct ContrastFilters {
  std::vector<float> luminance, red_green, blue_yellow_narrow, blue_yellow_wide;
};
ContrastFilters contrast_filters(float pixels_per_degree);

/// A Gaussian and its derivatives (section 4.2): the first finds edges, the second points and lines. The positive
/// weights of a derivative sum to 1, the negative ones to −1.
struct FeatureFilters {
  std::vector<float> gaussian, edge, point;
};
FeatureFilters feature_filters(float pixels_per_degree);

}  // namespace gibench
