#include "common/metrics/errors.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/metrics/intervals.h"
#include "common/metrics/picture_errors.h"
#include "common/metrics/value_metrics.h"

namespace gibench {

namespace {

/// `what` names the values in the error.
void check_finite(std::span<const Rgb> values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_finite(values[i]))
      throw InputError(what + "[" + std::to_string(i) + "]", "is not finite, so that no error can be taken",
                       "give finite values");
}

/// The means of a reference with their storage.
struct HalvedReference {
  const Replicas& replicas;
  std::vector<Rgb> mean, half_a, half_b, noisy;

  explicit HalvedReference(const Replicas& set) : replicas(set) {
    if (set.count() < 2)
      throw InputError("reference", "errors need two replicates at least, and it has " + std::to_string(set.count()),
                       "make it with more replicates");
    mean = set.mean(), half_a = set.half(0), half_b = set.half(1);
    check_finite(mean, "reference");
    noisy = values_with_noise_only(means());
  }
  ReferenceMeans means() const { return {mean, half_a, half_b}; }
  std::vector<double> influences(const MetricEstimate& estimate) const {
    return slope_influences(estimate.slope, replicas, mean);
  }
};

ErrorValue with_floor(ErrorValue error, double floor) {
  error.noise_floor = floor;
  error.below_noise_floor = std::abs(error.value) < floor;
  return error;
}

/// A mean of squares taken over the halves: the estimate is unbiased and so may be negative, the error is not.
ErrorValue squared_error(const HalvedReference& reference, const MetricEstimate& estimate, double floor) {
  const Interval interval = student_interval(estimate.value, reference.influences(estimate));
  return with_floor({std::max(0.0, estimate.value), std::max(0.0, interval.low), std::max(0.0, interval.high), {}, false}, floor);
}

/// Its root: the interval's ends are carried through.
ErrorValue root(const ErrorValue& square) {
  return {std::sqrt(square.value), std::sqrt(square.low), std::sqrt(square.high), std::sqrt(*square.noise_floor),
          square.below_noise_floor};
}

ErrorValue absolute_error(const HalvedReference& reference, const MetricEstimate& estimate, double floor) {
  return error_against_mean(estimate.value, student_interval(estimate.value, reference.influences(estimate)), floor);
}

/// The maximum picks the value whose noise is largest: it may be too large by all of the largest noise.
ErrorValue largest(const HalvedReference& reference, const MetricEstimate& estimate, double floor) {
  const Interval interval = student_interval(estimate.value, reference.influences(estimate));
  return with_floor({estimate.value, std::max(0.0, interval.low - floor), interval.high, {}, false}, floor);
}

using Metric = MetricEstimate (*)(std::span<const Rgb>, const ReferenceMeans&);

/// What a metric gives for values whose only error is the reference's own noise.
double floor_of(Metric metric, const HalvedReference& reference) {
  return metric(reference.noisy, ReferenceMeans::exact(reference.mean)).value;
}

ErrorTable errors_of_values(std::span<const Rgb> values, const HalvedReference& reference) {
  check_finite(values, "values");
  GIBENCH_CHECK(values.size() == reference.mean.size(), "one reference value for each value");
  const ReferenceMeans means = reference.means();
  const auto squared = [&](Metric metric) {
    return squared_error(reference, metric(values, means), floor_of(metric, reference));
  };
  const auto absolute = [&](Metric metric) {
    return absolute_error(reference, metric(values, means), floor_of(metric, reference));
  };
  ErrorTable table;
  table["rmse"] = root(squared(mean_squared_error));
  if (const auto relative = relative_mean_squared_error(values, means)) {
    const double floor = relative_mean_squared_error(reference.noisy, ReferenceMeans::exact(reference.mean))->value;
    table["relative_rmse"] = root(squared_error(reference, *relative, floor));
  }
  if (const auto bias = relative_bias(values, means)) {
    const std::vector<double> influences = reference.influences(*bias);
    const Interval interval = student_interval(bias->value, influences);
    table["bias"] = with_floor({bias->value, interval.low, interval.high, {}, false}, standard_error(influences));
  }
  table["rel_mse(0.01)"] = squared(relative_squared_error);
  table["rel_mse_trim(0.1%)"] = squared(trimmed_relative_squared_error);
  table["mape(0.01)"] = absolute(mean_absolute_percentage_error);
  table["smape(0.02)"] = absolute(symmetric_mean_absolute_percentage_error);
  table["max"] = largest(reference, largest_error(values, means), floor_of(largest_error, reference));
  return table;
}

}  // namespace

ErrorTable value_errors(std::span<const Rgb> values, const Replicas& reference) {
  return errors_of_values(values, HalvedReference(reference));
}

ErrorTable image_errors(int width, int height, std::span<const Rgb> pixels, const Replicas& reference, const Exposure& exposure) {
  const HalvedReference halves(reference);
  ErrorTable table = errors_of_values(pixels, halves);
  table.merge(picture_errors(width, height, pixels, reference, exposure));
  return table;
}

std::map<std::string, double> exact_value_errors(std::span<const Rgb> values, std::span<const Rgb> reference) {
  const ReferenceMeans exact = ReferenceMeans::exact(reference);
  std::map<std::string, double> table;
  table["rmse"] = std::sqrt(mean_squared_error(values, exact).value);
  if (const auto relative = relative_mean_squared_error(values, exact)) table["relative_rmse"] = std::sqrt(relative->value);
  if (const auto bias = relative_bias(values, exact)) table["bias"] = bias->value;
  table["rel_mse(0.01)"] = relative_squared_error(values, exact).value;
  table["rel_mse_trim(0.1%)"] = trimmed_relative_squared_error(values, exact).value;
  table["mape(0.01)"] = mean_absolute_percentage_error(values, exact).value;
  table["smape(0.02)"] = symmetric_mean_absolute_percentage_error(values, exact).value;
  table["max"] = largest_error(values, exact).value;
  return table;
}

}  // namespace gibench
