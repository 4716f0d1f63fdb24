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
  std::vector<Rgb> noisy, noisier;  ///< with the noise of the mean, and of two thirds, for their one error

  explicit NoisyReference(const Replicas& set)
      : HalvedReference(set),
        noisy(values_with_noise_only(means())),
        noisier(values_with_noise_only(means(), noise_of_two_thirds)) {}
};

/// Of the noise: at least its mean absolute value, by which |x−r| is too large at most. Where few values hold most of the noise,
/// as with fireflies, the halves' difference shows the former far better than the latter.
double root_mean_square(std::span<const double> parts) {
  double squares = 0.0;
  for (const double part : parts) squares += part * part;
  return std::sqrt(squares / static_cast<double>(parts.size()));
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

ErrorValue error_of(const ValueMetric& metric, const SeededEstimate& over, const NoisyReference& reference) {
  const MetricEstimate& estimate = over.mean;
  const std::vector<double> influences = reference.influences(estimate);
  Interval interval = interval_over_points(estimate.value, influences, estimate.parts, over.point_noise);
  interval = widened(interval, estimate.value, seed_reach(over.values));
  if (metric.taken == Taken::with_sign)
    return {estimate.value, interval.low, interval.high, standard_error(influences), interval.low > 0.0 || interval.high < 0.0};
  // What the metric gives for values whose only error is noise.
  const bool of_two_thirds = metric.taken == Taken::against_two_thirds;
  const auto noise = metric.estimate(of_two_thirds ? reference.noisier : reference.noisy, ReferenceMeans::exact(reference.mean));
  const double floor = noise.value().value;
  switch (metric.taken) {
    case Taken::as_square: return positive(estimate.value, interval, floor);
    case Taken::as_root_of_square: return root(positive(estimate.value, interval, floor));
    case Taken::against_two_thirds:
      interval.low -= root_mean_square(noise->parts);
      return positive(estimate.value, interval, floor);
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

std::optional<double> deviation_of(const ValueMetric& metric, std::vector<double> values) {
  if (metric.taken == Taken::as_root_of_square)
    for (double& value : values) value = std::sqrt(std::max(0.0, value));
  return deviation_of(std::move(values));
}

/// Calls `use` with every metric of linear values that is defined here, and its estimates.
template <class Use>
void for_each_estimate(std::span<const std::vector<Rgb>> values, const ReferenceMeans& means, const Use& use) {
  for (const Metric& metric : all_metrics()) {
    const ValueMetric* const of_values = value_metric(metric);
    if (of_values == nullptr) continue;
    std::vector<MetricEstimate> estimates;
    for (const std::vector<Rgb>& one : values)
      if (auto estimate = of_values->estimate(one, means)) estimates.push_back(std::move(*estimate));
    if (estimates.size() == values.size()) use(metric.name, *of_values, over_seeds(std::move(estimates)));
  }
}

ErrorTable errors_of_values(std::span<const std::vector<Rgb>> values, const NoisyReference& reference) {
  for (const std::vector<Rgb>& one : values) {
    check_finite(one, "values");
    GIBENCH_CHECK(one.size() == reference.mean.size(), "one reference value for each value");
  }
  ErrorTable table;
  for_each_estimate(values, reference.means(),
                    [&](const std::string& name, const ValueMetric& metric, const SeededEstimate& over) {
                      ErrorValue& error = table[name] = error_of(metric, over, reference);
                      error.seed_deviation = deviation_of(metric, over.values);
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
                    [&](const std::string& name, const ValueMetric& metric, const SeededEstimate& over) {
                      table[name] = metric.taken == Taken::as_root_of_square ? std::sqrt(over.mean.value) : over.mean.value;
                    });
  return table;
}

}  // namespace gibench
