#include "common/metrics/value_metrics.h"

#include <cmath>

#include "common/metrics/metric_terms.h"

namespace gibench {

using namespace metric_terms;

std::vector<Rgb> values_with_noise_only(const ReferenceMeans& reference) {
  std::vector<Rgb> values(reference.mean.begin(), reference.mean.end());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.5F * (reference.half_a[i] - reference.half_b[i]);
  return values;
}

MetricEstimate mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return sum_terms(values, reference,
                   [](std::size_t, const Compared& at) {
                     return Term{(at.x - at.a) * (at.x - at.b), -2.0 * (at.x - at.r)};
                   })
      .estimate;
}

std::optional<MetricEstimate> relative_mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  const double mean = mean_of(reference.mean), squared = mean * mean;
  if (!(mean > 0.0)) return std::nullopt;
  MetricEstimate estimate = mean_squared_error(values, reference);
  const auto scale = static_cast<float>(1.0 / squared);
  for (Rgb& slope : estimate.slope) slope = scale * slope;
  for (double& part : estimate.parts) part /= squared;
  add_slope_of_mean(estimate, reference.mean, mean, -2.0 * estimate.value / (squared * mean));
  estimate.value /= squared;
  return estimate;
}

std::optional<MetricEstimate> relative_bias(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  const double mean = mean_of(reference.mean), of_values = mean_of(values);
  if (!(mean > 0.0)) return std::nullopt;
  MetricEstimate estimate{(of_values - mean) / mean, std::vector<Rgb>(values.size()), std::vector<double>(values.size())};
  for (std::size_t i = 0; i < values.size(); ++i) estimate.parts[i] = mean_of(values.subspan(i, 1)) / mean - 1.0;
  add_slope_of_mean(estimate, reference.mean, mean, -of_values / (mean * mean));
  return estimate;
}

MetricEstimate largest_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  MetricEstimate estimate{0.0, std::vector<Rgb>(values.size()), {}};
  std::size_t place = 0;
  int channel = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(double{values[i][c]} - double{reference.mean[i][c]});
      if (error > estimate.value) estimate.value = error, place = i, channel = c;
    }
  estimate.slope[place][channel] = 3.0F * static_cast<float>(values.size()) *
                                   static_cast<float>(sign_of(reference.mean[place][channel] - values[place][channel]));
  return estimate;
}

}  // namespace gibench
