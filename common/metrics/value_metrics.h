/// The error metrics of linear values x against a reference r, one function each: the value, and how it moves with
/// the reference. A mean is taken over values and channels alike. Squared errors are taken as (x−A)(x−B) over two parts of
/// the reference, whose noise is independent, so that E[(x−A)(x−B)] = (x−μ)² without the reference's noise. Where a weight
/// holds r, it is taken from a third part, or the weight and the error would share their noise. The constants of the weights
/// are shares of M, the mean of r, so that no unit changes a ranking.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// The mean of the reference, its halves and its thirds (empty: it has none); all the same for a reference without noise.
struct ReferenceMeans {
  std::span<const Rgb> mean, half_a, half_b;
  std::array<std::span<const Rgb>, 3> thirds;
  static ReferenceMeans exact(std::span<const Rgb> values) { return {values, values, values, {values, values, values}}; }
};

/// mean + factor (A−B)/2: values whose one error has `factor` times the noise of the mean. What a metric gives for them against
/// the mean is its noise floor; for the squared error and a factor of one that is ¼ mean (A−B)².
std::vector<Rgb> values_with_noise_only(const ReferenceMeans& reference, double factor = 1.0);

/// A metric with its derivative by the reference, from which its interval follows.
struct MetricEstimate {
  double value = 0.0;
  std::vector<Rgb> slope;     ///< 3 n ∂value/∂r at every value and channel
  std::vector<double> parts;  ///< of every value, to first order: their mean is the value; empty for a maximum
};

/// mean (x−A)(x−B) over the halves: may be negative where the error is far below the noise.
MetricEstimate mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);

// All others but the largest error are empty where M is not positive, and those with weights where there are no thirds.

/// mean_squared_error / M².
std::optional<MetricEstimate> relative_mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// mean(x − r) / M.
std::optional<MetricEstimate> relative_bias(std::span<const Rgb> values, const ReferenceMeans& reference);
/// rel_mse(0.01): mean (x−A)(x−B) / (C² + 0.01 M²), the mean over the three ways to take two thirds A, B and the third C.
std::optional<MetricEstimate> relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// rel_mse_trim(0.1%): the same without the ⌊n/1000⌋ of the n values whose (x−r)²/(r²+0.01 M²), averaged over the channels, is
/// largest (of equal ones the later go first). Under 1000 values nothing is left out.
std::optional<MetricEstimate> trimmed_relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// mape(0.01): mean |x−B| / (|C| + 0.01 M), B the mean of two thirds and C the third, over the three ways.
std::optional<MetricEstimate> mean_absolute_percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// smape(0.02): mean 2|x−B| / (|x| + |C| + 0.02 M), likewise.
std::optional<MetricEstimate> symmetric_mean_absolute_percentage_error(std::span<const Rgb> values,
                                                                       const ReferenceMeans& reference);
/// max |x−r| over values and channels.
MetricEstimate largest_error(std::span<const Rgb> values, const ReferenceMeans& reference);

/// The noise of the mean of two thirds over that of the mean of all: √(3/2).
inline constexpr double noise_of_two_thirds = 1.2247448713915890;

}  // namespace gibench
