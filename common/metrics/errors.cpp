#include "common/metrics/errors.h"

#include <algorithm>
#include <array>
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
  std::vector<Rgb> mean, half_a, half_b;
  std::array<std::vector<Rgb>, 3> thirds;
  std::vector<Rgb> noisy, noisier;  ///< with the noise of the mean, and of two thirds, for their one error

  explicit HalvedReference(const Replicas& set) : replicas(set) {
    if (set.count() < 2)
      throw InputError("reference", "errors need two replicates at least, and it has " + std::to_string(set.count()),
                       "make it with more replicates");
    mean = set.mean(), half_a = set.half(0), half_b = set.half(1);
    check_finite(mean, "reference");
    // Two replicates have no thirds: metrics with weights are not defined.
    if (set.count() > 2) thirds = {set.third(0), set.third(1), set.third(2)};
    noisy = values_with_noise_only(means());
    noisier = values_with_noise_only(means(), noise_of_two_thirds);
  }
  ReferenceMeans means() const { return {mean, half_a, half_b, {thirds[0], thirds[1], thirds[2]}}; }

  std::vector<double> influences(const MetricEstimate& estimate) const {
    return slope_influences(estimate.slope, replicas, mean);
  }
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

ErrorValue error_of(const ValueMetric& metric, const MetricEstimate& estimate, const HalvedReference& reference) {
  const std::vector<double> influences = reference.influences(estimate);
  Interval interval = interval_over_points(estimate.value, influences, estimate.parts);
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
