#include "common/metrics/errors.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/metrics/intervals.h"
#include "common/metrics/metric_table.h"
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

ErrorValue signed_error(const HalvedReference& reference, const MetricEstimate& estimate) {
  const std::vector<double> influences = reference.influences(estimate);
  const Interval interval = student_interval(estimate.value, influences);
  return with_floor({estimate.value, interval.low, interval.high, {}, false}, standard_error(influences));
}

/// What a metric gives for values whose only error is the reference's own noise.
double floor_of(const ValueMetric& metric, const HalvedReference& reference) {
  return metric.estimate(reference.noisy, ReferenceMeans::exact(reference.mean)).value().value;
}

ErrorValue error_of(const ValueMetric& metric, const MetricEstimate& estimate, const HalvedReference& reference) {
  switch (metric.taken) {
    case Taken::as_square: return squared_error(reference, estimate, floor_of(metric, reference));
    case Taken::as_root_of_square: return root(squared_error(reference, estimate, floor_of(metric, reference)));
    case Taken::with_sign: return signed_error(reference, estimate);
    case Taken::against_mean: return absolute_error(reference, estimate, floor_of(metric, reference));
    case Taken::as_largest: return largest(reference, estimate, floor_of(metric, reference));
  }
  return {};
}

/// Calls `use` with every metric of linear values that is defined here, and its estimate.
template <class Use>
void for_each_estimate(std::span<const Rgb> values, const ReferenceMeans& means, const Use& use) {
  for (const Metric& metric : all_metrics())
    if (const auto* of_values = value_metric(metric))
      if (const auto estimate = of_values->estimate(values, means)) use(metric.name, *of_values, *estimate);
}

ErrorTable errors_of_values(std::span<const Rgb> values, const HalvedReference& reference) {
  check_finite(values, "values");
  GIBENCH_CHECK(values.size() == reference.mean.size(), "one reference value for each value");
  ErrorTable table;
  for_each_estimate(values, reference.means(),
                    [&](const std::string& name, const ValueMetric& metric, const MetricEstimate& estimate) {
                      table[name] = error_of(metric, estimate, reference);
                    });
  return table;
}

}  // namespace

ErrorTable value_errors(std::span<const Rgb> values, const Replicas& reference) {
  return errors_of_values(values, HalvedReference(reference));
}

ErrorTable image_errors(int width, int height, std::span<const Rgb> pixels, const Replicas& reference, const Exposure& exposure) {
  const HalvedReference halves(reference);
  ErrorTable table = errors_of_values(pixels, halves);
  const PictureComparison comparison = compare_pictures(width, height, pixels, reference, exposure);
  for (const Metric& metric : all_metrics())
    if (const auto* of_pictures = picture_metric(metric))
      if (const auto error = of_pictures->error(comparison)) table[metric.name] = *error;
  return table;
}

std::map<std::string, double> exact_value_errors(std::span<const Rgb> values, std::span<const Rgb> reference) {
  std::map<std::string, double> table;
  for_each_estimate(values, ReferenceMeans::exact(reference),
                    [&](const std::string& name, const ValueMetric& metric, const MetricEstimate& estimate) {
                      table[name] = metric.taken == Taken::as_root_of_square ? std::sqrt(estimate.value) : estimate.value;
                    });
  return table;
}

}  // namespace gibench
