#include "common/metrics/seeded_estimate.h"

#include <cmath>

#include "common/core/error.h"

namespace gibench {

namespace {

void add(MetricEstimate& sum, const MetricEstimate& other) {
  GIBENCH_CHECK(sum.slope.size() == other.slope.size() && sum.parts.size() == other.parts.size() &&
                    sum.without_group.size() == other.without_group.size(),
                "every seed answers alike");
  sum.value += other.value, sum.correction += other.correction;
  for (std::size_t i = 0; i < sum.slope.size(); ++i) sum.slope[i] += other.slope[i];
  for (std::size_t i = 0; i < sum.parts.size(); ++i) sum.parts[i] += other.parts[i];
  for (std::size_t i = 0; i < sum.without_group.size(); ++i) sum.without_group[i] += other.without_group[i];
}

void scale(MetricEstimate& estimate, double factor) {
  estimate.value *= factor, estimate.correction *= factor;
  for (Rgb& slope : estimate.slope) slope *= static_cast<float>(factor);
  for (double& part : estimate.parts) part *= factor;
  for (double& value : estimate.without_group) value *= factor;
}

/// V, from the sum of squares of the interaction.
double point_noise_of(const std::vector<MetricEstimate>& estimates, const MetricEstimate& mean) {
  const std::size_t points = mean.parts.size();
  if (points < 2) return 0.0;
  double squares = 0.0;
  for (const MetricEstimate& estimate : estimates)
    for (std::size_t i = 0; i < points; ++i) {
      const double apart = estimate.parts[i] - mean.parts[i] - estimate.value + mean.value;
      squares += apart * apart;
    }
  const auto n = static_cast<double>(points), seeds = static_cast<double>(estimates.size());
  return squares / (seeds * n * (n - 1.0) * (seeds - 1.0));
}

}  // namespace

SeededEstimate over_seeds(std::vector<MetricEstimate> estimates) {
  GIBENCH_CHECK(!estimates.empty(), "a method answers with one seed at least");
  SeededEstimate over;
  for (const MetricEstimate& estimate : estimates) over.values.push_back(estimate.value);
  if (estimates.size() == 1) {
    over.mean = std::move(estimates.front());
    return over;
  }
  over.mean = estimates.front();
  for (std::size_t k = 1; k < estimates.size(); ++k) add(over.mean, estimates[k]);
  scale(over.mean, 1.0 / static_cast<double>(estimates.size()));
  over.point_noise = point_noise_of(estimates, over.mean);
  return over;
}

double seed_reach(std::span<const double> values) {
  if (values.size() < 2) return 0.0;
  return student_interval(0.0, values).high;
}

Interval widened(const Interval& interval, double value, double reach) {
  return {value - std::hypot(value - interval.low, reach), value + std::hypot(interval.high - value, reach)};
}

}  // namespace gibench
