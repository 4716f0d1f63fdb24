#include "common/metrics/errors.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/metrics/halved_reference.h"
#include "common/metrics/intervals.h"
#include "common/metrics/metric_table.h"
#include "common/metrics/picture_errors.h"
#include "common/metrics/seeded_estimate.h"
#include "common/metrics/value_metrics.h"

namespace gibench {

namespace {

/// A reference with what a metric gives for values whose only error is noise.
struct NoisyReference : HalvedReference {
  std::vector<Rgb> noisy;  ///< with the noise of the mean for their one error

  explicit NoisyReference(const Replicas& set) : HalvedReference(set), noisy(values_with_noise_only(means())) {}
};

/// A metric of the values with each seed.
struct Estimated {
  SeededEstimate over;
  std::optional<SeededEstimate> at_least;  ///< the smaller one of two
};

double between(double at_least, double at_most) { return std::sqrt(std::max(0.0, at_least) * std::max(0.0, at_most)); }

/// What the reference and the points leave uncertain, with the noise of weights, and the seeds.
Interval interval_of(const SeededEstimate& over, std::span<const double> influences) {
  const MetricEstimate& estimate = over.mean;
  Interval interval = interval_over_points(estimate.value, influences, estimate.parts, over.point_noise);
  interval = widened(interval, estimate.value, seed_reach(over.values));
  return with_weights(interval, estimate.correction, estimate.least_share);
}

/// Not negative, whatever the estimate is.
ErrorValue positive(double value, const Interval& interval, double floor) {
  return {std::max(0.0, value), std::max(0.0, interval.low), std::max(0.0, interval.high), floor, interval.low > 0.0};
}

/// The root of a mean of squares: the interval's ends are carried through.
ErrorValue root(const ErrorValue& square) {
  return {std::sqrt(square.value), std::sqrt(square.low), std::sqrt(square.high), std::sqrt(*square.noise_floor),
          square.resolved};
}

ErrorValue error_of(const ValueMetric& metric, const Estimated& estimated, const NoisyReference& reference) {
  const MetricEstimate& estimate = estimated.over.mean;
  const std::vector<double> influences = reference.influences(estimate);
  Interval interval = interval_of(estimated.over, influences);
  if (metric.taken == Taken::with_sign)
    return {estimate.value, interval.low, interval.high, standard_error(influences), interval.low > 0.0 || interval.high < 0.0};
  // What the metric gives for values whose only error is noise.
  const double floor = metric.estimate(reference.noisy, ReferenceMeans::exact(reference.mean)).value().value;
  switch (metric.taken) {
    case Taken::as_square: return positive(estimate.value, interval, floor);
    case Taken::as_root_of_square: return root(positive(estimate.value, interval, floor));
    case Taken::between: {
      const SeededEstimate& at_least = estimated.at_least.value();
      interval.low = interval_of(at_least, reference.influences(at_least.mean)).low;
      return positive(between(at_least.mean.value, estimate.value), interval, floor);
    }
    case Taken::as_largest:
      // The maximum picks the value whose noise is largest: it may be too large by all of the largest noise.
      interval.low -= floor;
      return positive(estimate.value, interval, floor);
    case Taken::with_sign: break;
  }
  return {};
}

/// Of the values of one metric with each seed; empty for one seed.
std::optional<double> deviation_of(std::vector<double> values) {
  if (values.size() < 2) return std::nullopt;
  return standard_error(values) * std::sqrt(static_cast<double>(values.size()));
}

std::optional<double> deviation_of(const ValueMetric& metric, const Estimated& estimated) {
  std::vector<double> values = estimated.over.values;
  if (metric.taken == Taken::as_root_of_square)
    for (double& value : values) value = std::sqrt(std::max(0.0, value));
  if (estimated.at_least)
    for (std::size_t seed = 0; seed < values.size(); ++seed)
      values[seed] = between(estimated.at_least->values[seed], values[seed]);
  return deviation_of(std::move(values));
}

/// With each seed; empty where the metric is not defined.
std::optional<SeededEstimate> estimate_of(ValueMetric::Estimate estimate, std::span<const std::vector<Rgb>> values,
                                          const ReferenceMeans& means) {
  std::vector<MetricEstimate> estimates;
  for (const std::vector<Rgb>& one : values)
    if (auto of_one = estimate(one, means)) estimates.push_back(std::move(*of_one));
  if (estimates.size() < values.size()) return std::nullopt;
  return over_seeds(std::move(estimates));
}

/// Calls `use` with every metric of linear values that is defined here, and its estimates.
template <class Use>
void for_each_estimate(std::span<const std::vector<Rgb>> values, const ReferenceMeans& means, const Use& use) {
  for (const Metric& metric : all_metrics()) {
    const ValueMetric* const of_values = value_metric(metric);
    if (of_values == nullptr) continue;
    auto over = estimate_of(of_values->estimate, values, means);
    if (!over) continue;
    Estimated estimated{std::move(*over), {}};
    if (of_values->at_least) estimated.at_least = estimate_of(of_values->at_least, values, means);
    use(metric.name, *of_values, estimated);
  }
}

ErrorTable errors_of_values(std::span<const std::vector<Rgb>> values, const NoisyReference& reference) {
  for (const std::vector<Rgb>& one : values) {
    check_finite(one, "values");
    GIBENCH_CHECK(one.size() == reference.mean.size(), "one reference value for each value");
  }
  ErrorTable table;
  for_each_estimate(values, reference.means(),
                    [&](const std::string& name, const ValueMetric& metric, const Estimated& estimated) {
                      ErrorValue& error = table[name] = error_of(metric, estimated, reference);
                      error.seed_deviation = deviation_of(metric, estimated);
                    });
  return table;
}

/// An error of a picture with each seed: the mean, and what the seeds add to its interval, within the metric's range.
ErrorValue picture_error_over(const Metric& metric, const std::vector<ErrorValue>& errors) {
  const auto is_infinite = [](const ErrorValue& error) { return !std::isfinite(error.value); };
  if (errors.size() == 1 || std::ranges::any_of(errors, is_infinite)) return errors.front();
  const auto count = static_cast<double>(errors.size());
  ErrorValue over{0.0, 0.0, 0.0, 0.0, true};
  std::vector<double> values;
  for (const ErrorValue& error : errors) {
    over.value += error.value / count, over.low += error.low / count, over.high += error.high / count;
    *over.noise_floor += error.noise_floor.value_or(0.0) / count;
    over.resolved = over.resolved && error.resolved;
    values.push_back(error.value);
  }
  const Interval interval = widened({over.low, over.high}, over.value, seed_reach(values));
  const bool of_similarity = metric.better == Better::nearer_to_one, of_error = metric.better == Better::smaller;
  over.low = of_similarity ? std::max(-1.0, interval.low) : of_error ? std::max(0.0, interval.low) : interval.low;
  over.high = of_similarity ? std::min(1.0, interval.high) : interval.high;
  over.resolved = over.resolved && !(of_similarity && interval.high >= 1.0) && !(of_error && interval.low <= 0.0);
  over.seed_deviation = deviation_of(std::move(values));
  return over;
}

/// The same values as those of one seed.
std::vector<std::vector<Rgb>> of_one_seed(std::span<const Rgb> values) { return {{values.begin(), values.end()}}; }

}  // namespace

ErrorTable value_errors(std::span<const std::vector<Rgb>> values, const Replicas& reference) {
  return errors_of_values(values, NoisyReference(reference));
}

ErrorTable value_errors(std::span<const Rgb> values, const Replicas& reference) {
  return value_errors(of_one_seed(values), reference);
}

ErrorTable image_errors(int width, int height, std::span<const std::vector<Rgb>> pixels, const Replicas& reference,
                        const Exposure& exposure) {
  ErrorTable table = errors_of_values(pixels, NoisyReference(reference));
  std::map<std::string, std::vector<ErrorValue>> of_seeds;
  for (const std::vector<Rgb>& one : pixels) {
    const PictureComparison comparison = compare_pictures(width, height, one, reference, exposure);
    for (const Metric& metric : all_metrics())
      if (const auto* of_pictures = picture_metric(metric))
        if (const auto error = of_pictures->error(comparison)) of_seeds[metric.name].push_back(*error);
  }
  for (const auto& [name, errors] : of_seeds) table[name] = picture_error_over(*find_metric(name), errors);
  return table;
}

ErrorTable image_errors(int width, int height, std::span<const Rgb> pixels, const Replicas& reference, const Exposure& exposure) {
  return image_errors(width, height, of_one_seed(pixels), reference, exposure);
}

std::map<std::string, double> exact_value_errors(std::span<const Rgb> values, std::span<const Rgb> reference) {
  std::map<std::string, double> table;
  for_each_estimate(of_one_seed(values), ReferenceMeans::exact(reference),
                    [&](const std::string& name, const ValueMetric& metric, const Estimated& estimated) {
                      const double value = estimated.over.mean.value;
                      table[name] = metric.taken == Taken::as_root_of_square ? std::sqrt(value) : value;
                    });
  return table;
}

}  // namespace gibench
