/// The error metrics of linear values x against a reference r, one function each: the value, and how it moves with
/// the reference. A mean is taken over values and channels alike. Squared errors are taken as (x−A)(x−B) over two parts of
/// the reference, whose noise is independent, so that E[(x−A)(x−B)] = (x−μ)² without the reference's noise. Metrics whose
/// weights hold r are in weighted_metrics.h.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/metrics/metric_estimate.h"

namespace gibench {

/// mean + (A−B)/2: values whose one error has the noise of the mean. What a metric gives for them against the mean is its noise
/// floor; for the squared error that is ¼ mean (A−B)².
std::vector<Rgb> values_with_noise_only(const ReferenceMeans& reference);

/// mean (x−A)(x−B) over the halves: may be negative where the error is far below the noise.
MetricEstimate mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);

// Both are empty where M is not positive.

/// mean_squared_error / M².
std::optional<MetricEstimate> relative_mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);
/// mean(x − r) / M.
std::optional<MetricEstimate> relative_bias(std::span<const Rgb> values, const ReferenceMeans& reference);

/// max |x−r| over values and channels.
MetricEstimate largest_error(std::span<const Rgb> values, const ReferenceMeans& reference);

}  // namespace gibench
