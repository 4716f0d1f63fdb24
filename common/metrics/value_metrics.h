/// The error metrics of linear values x against a reference r, one function each: the value, and how it moves with
/// the reference. A mean is taken over values and channels alike. Squared errors are taken as (x−A)(x−B) over the two
/// halves of the reference, whose noise is independent, so that E[(x−A)(x−B)] = (x−μ)² without the reference's noise;
/// the other metrics are taken against the mean r.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// The mean of the reference and its halves; all three the same for a reference without noise.
struct ReferenceMeans {
  std::span<const Rgb> mean, half_a, half_b;
  static ReferenceMeans exact(std::span<const Rgb> values) { return {values, values, values}; }
};

/// mean + (A−B)/2: values whose one error is as large as the noise of the mean and distributed alike. What a metric gives
/// for them against the mean is its noise floor; for the squared error that is ¼ mean (A−B)².
std::vector<Rgb> values_with_noise_only(const ReferenceMeans& reference);

/// A metric with its derivative by the reference, from which its interval follows.
struct MetricEstimate {
  double value = 0.0;
  std::vector<Rgb> slope;  ///< 3 n ∂value/∂r at every value and channel
};

/// mean (x−A)(x−B): may be negative where the error is far below the noise.
MetricEstimate mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// mean_squared_error / (mean r)². Empty where the mean of r is not positive.
std::optional<MetricEstimate> relative_mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// mean(x − r) / mean r. Empty where the mean of r is not positive.
std::optional<MetricEstimate> relative_bias(std::span<const Rgb> values, const ReferenceMeans& reference);
/// rel_mse(0.01): mean (x−A)(x−B) / (r² + 0.01).
MetricEstimate relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// rel_mse_trim(0.1%): the same without the ⌊n/1000⌋ of the n values whose (x−r)²/(r²+0.01), averaged over the channels, is
/// largest (of equal ones the later go first). Under 1000 values nothing is left out.
MetricEstimate trimmed_relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// mape(0.01): mean |x−r| / (|r| + 0.01).
MetricEstimate mean_absolute_percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// smape(0.02): mean 2|x−r| / (|x| + |r| + 0.02).
MetricEstimate symmetric_mean_absolute_percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// max |x−r| over values and channels.
MetricEstimate largest_error(std::span<const Rgb> values, const ReferenceMeans& reference);

}  // namespace gibench
