#include "common/metrics/picture_errors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/error.h"
#include "common/image/tone_mapping.h"
#include "common/metrics/display_metrics.h"
#include "common/metrics/hdr_flip.h"
#include "common/metrics/value_metrics.h"

namespace gibench {

namespace {

constexpr std::size_t most_groups = 8;

Pictures pictures_of(std::span<const Rgb> pixels, const Replicas& reference) {
  const std::vector<Rgb> half_a = reference.half(0), half_b = reference.half(1);
  Pictures pictures{{pixels.begin(), pixels.end()}, reference.mean(), {}, {}};
  pictures.noisy = values_with_noise_only({pictures.mean, half_a, half_b, {}});
  const std::size_t groups = std::min(reference.count(), most_groups);
  for (std::size_t group = 0; group < groups; ++group) pictures.without.push_back(reference.mean_without(group, groups));
  return pictures;
}

Pictures displayed(const Pictures& pictures, float exposure) {
  Pictures shown{display_values(pictures.test, exposure),
                 display_values(pictures.mean, exposure),
                 display_values(pictures.noisy, exposure),
                 {}};
  for (const std::vector<Rgb>& picture : pictures.without) shown.without.push_back(display_values(picture, exposure));
  return shown;
}

/// A metric's value, what the reference's own noise gives, and the interval of the value.
struct Measured {
  double value, noise;
  Interval interval;
};

Measured measured(double value, double noise, const std::vector<double>& without) {
  return {value, noise, student_interval(value, delete_one_influences(without))};
}

template <class Metric>
Measured measured(const Pictures& shown, const Metric& metric) {
  std::vector<double> without;
  for (const std::vector<Rgb>& picture : shown.without) without.push_back(metric(shown.test, picture));
  return measured(metric(shown.test, shown.mean), metric(shown.noisy, shown.mean), without);
}

/// The similarity of a picture without error to the mean of the reference, from that of the noisy twin, 1 − t. With a local
/// variance of s in the picture and q in the mean's noise, the twin has t = q / (2s + 3q), having the noise twice, and the
/// picture without error q / (2s + q) = t / (1 − 2t).
double similarity_without_error(double similarity_of_twin) {
  const double t = 1.0 - similarity_of_twin;
  return t < 1.0 / 3.0 ? 1.0 - t / (1.0 - 2.0 * t) : 0.0;
}

/// The largest error of each pixel over the exposures seen so far.
class LargestErrors {
 public:
  void add(const std::vector<float>& errors) {
    if (largest_.empty()) largest_ = errors;
    else std::ranges::transform(largest_, errors, largest_.begin(), [](float a, float b) { return std::max(a, b); });
  }
  double mean() const { return std::accumulate(largest_.begin(), largest_.end(), 0.0) / static_cast<double>(largest_.size()); }

 private:
  std::vector<float> largest_;
};

/// Shows a picture at an exposure, for FLIP: linear, in [0, 1].
using Display = std::vector<Rgb> (*)(std::span<const Rgb>, float);

/// FLIP, largest over the exposures; the part of each picture is made once and used in every comparison.
ErrorValue flip_error_over(const PictureComparison& comparison, std::span<const float> exposures, Display display) {
  const Pictures& pictures = comparison.linear;
  LargestErrors value, noise;
  std::vector<LargestErrors> without(pictures.without.size());
  for (const float exposure : exposures) {
    const auto features_of = [&](std::span<const Rgb> picture) {
      return flip_features(comparison.width, comparison.height, display(picture, exposure), default_pixels_per_degree);
    };
    const FlipFeatures test = features_of(pictures.test), mean = features_of(pictures.mean);
    value.add(flip_differences(mean, test));
    noise.add(flip_differences(mean, features_of(pictures.noisy)));
    for (std::size_t i = 0; i < without.size(); ++i) without[i].add(flip_differences(features_of(pictures.without[i]), test));
  }
  std::vector<double> values_without;
  for (const LargestErrors& errors : without) values_without.push_back(errors.mean());
  const Measured m = measured(value.mean(), noise.mean(), values_without);
  return error_against_mean(m.value, m.interval, m.noise);
}

}  // namespace

ErrorValue error_against_mean(double value, const Interval& interval, double floor) {
  const double low = std::max(0.0, interval.low);
  return {value, std::sqrt(std::max(0.0, low * low - floor * floor)), interval.high, floor, low > floor};
}

std::optional<ErrorValue> psnr_error(const PictureComparison& comparison) {
  const Measured m =
      measured(comparison.shown, [](const auto& picture, const auto& reference) { return psnr(picture, reference); });
  // The noise adds its mean square to the error's: the upper end is what is left without it.
  const double squares = std::pow(10.0, -0.1 * m.interval.high) - std::pow(10.0, -0.1 * m.noise);
  const double high = squares > 0.0 ? std::min(most_decibels, -10.0 * std::log10(squares)) : most_decibels;
  return ErrorValue{m.value, m.interval.low, std::max(high, m.value), m.noise, squares > 0.0};
}

std::optional<ErrorValue> ssim_error(const PictureComparison& comparison) {
  const int width = comparison.width, height = comparison.height;
  if (std::min(width, height) < ssim_window) return std::nullopt;
  const Measured m = measured(comparison.shown, [&](const auto& picture, const auto& reference) {
    return ssim(width, height, picture, reference).value();
  });
  const double ceiling = similarity_without_error(m.noise);
  const double high = m.interval.high + 1.0 - ceiling;
  return ErrorValue{m.value, std::max(-1.0, m.interval.low), std::min(1.0, high), ceiling, high < 1.0};
}

std::optional<ErrorValue> flip_error(const PictureComparison& comparison) {
  return flip_error_over(comparison, std::vector<float>{comparison.exposure.value},
                         [](std::span<const Rgb> picture, float stops) { return exposed(picture, stops); });
}

std::optional<ErrorValue> hdr_flip_error(const PictureComparison& comparison) {
  const std::vector<float> range = exposure_range(comparison.exposure.start, comparison.exposure.stop).exposures();
  return flip_error_over(comparison, range,
                         [](std::span<const Rgb> picture, float stops) { return tone_mapped(picture, stops, ToneMapper::aces); });
}

PictureComparison compare_pictures(int width, int height, std::span<const Rgb> pixels, const Replicas& reference,
                                   const Exposure& exposure) {
  GIBENCH_CHECK(pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height), "one value for each pixel");
  PictureComparison comparison{width, height, exposure, pictures_of(pixels, reference), {}};
  comparison.shown = displayed(comparison.linear, exposure.value);
  return comparison;
}

}  // namespace gibench
