#include "common/metrics/flip_filters.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/vec.h"
#include "common/metrics/separable_filter.h"

namespace gibench {

namespace {

/// a √(π/b) exp(−π² x²/b) at x degrees: the Fourier transform of the sensitivity a exp(−b f²) at f cycles a degree.
struct Sensitivity {
  double a, b;
};
constexpr Sensitivity luminance_sensitivity{1.0, 0.0047}, red_green_sensitivity{1.0, 0.0053};
constexpr Sensitivity blue_yellow_first{34.1, 0.04}, blue_yellow_second{13.5, 0.025};

constexpr double feature_width_degrees = 0.082;  // w, of the white line between two black ones that an observer resolves

/// Weights along one axis whose product with the other axis' is the sensitivity in space, not yet scaled.
std::vector<double> axis_weights(const Sensitivity& s, int radius, double pixels_per_degree) {
  std::vector<double> weights;
  for (int i = -radius; i <= radius; ++i) {
    const double x = i / pixels_per_degree;
    weights.push_back(std::sqrt(s.a * std::sqrt(pi_double / s.b)) * std::exp(-pi_double * pi_double * x * x / s.b));
  }
  return weights;
}

double sum_of(const std::vector<double>& weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

std::vector<float> scaled(const std::vector<double>& weights, double factor) {
  std::vector<float> filter;
  for (const double weight : weights) filter.push_back(static_cast<float>(factor * weight));
  return filter;
}

/// Positive weights summing to 1, negative ones to −1.
std::vector<float> balanced(const std::vector<double>& weights) {
  double positive = 0.0, negative = 0.0;
  for (const double weight : weights) (weight > 0.0 ? positive : negative) += std::abs(weight);
  std::vector<float> filter;
  for (const double weight : weights) filter.push_back(static_cast<float>(weight / (weight > 0.0 ? positive : negative)));
  return filter;
}

}  // namespace

ContrastFilters contrast_filters(float pixels_per_degree) {
  const double ppd = pixels_per_degree;
  const double widest = std::max({luminance_sensitivity.b, red_green_sensitivity.b, blue_yellow_first.b, blue_yellow_second.b});
  // Three standard deviations of the widest Gaussian.
  const int radius = static_cast<int>(std::ceil(3.0 * std::sqrt(widest / (2.0 * pi_double * pi_double)) * ppd));
  const std::vector<double> luminance = axis_weights(luminance_sensitivity, radius, ppd);
  const std::vector<double> red_green = axis_weights(red_green_sensitivity, radius, ppd);
  const std::vector<double> first = axis_weights(blue_yellow_first, radius, ppd);
  const std::vector<double> second = axis_weights(blue_yellow_second, radius, ppd);
  // The weights in the plane sum to 1: (Σ first)² + (Σ second)² for the sum of two products.
  const double both = 1.0 / std::hypot(sum_of(first), sum_of(second));
  return {scaled(luminance, 1.0 / sum_of(luminance)), scaled(red_green, 1.0 / sum_of(red_green)), scaled(second, both),
          scaled(first, both)};
}

FeatureFilters feature_filters(float pixels_per_degree) {
  const double sigma = 0.5 * feature_width_degrees * pixels_per_degree;
  const int radius = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<double> first, second;
  for (int x = -radius; x <= radius; ++x) {
    const double gaussian = std::exp(-0.5 * x * x / (sigma * sigma));
    first.push_back(-x * gaussian);
    second.push_back((x * x / (sigma * sigma) - 1.0) * gaussian);
  }
  return {gaussian_filter(sigma, radius), balanced(first), balanced(second)};
}

}  // namespace gibench
