#include "common/metrics/pair_terms.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/metrics/halved_reference.h"
#include "common/metrics/metric_table.h"
#include "common/metrics/seeded_estimate.h"

namespace gibench {

namespace {

/// The points in an order that depends on their number alone: pixels that are near each other come into different groups.
std::vector<std::size_t> shuffled(std::size_t count) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  RandomStream random(count, 0, 0);
  for (std::size_t i = count; i > 1; --i) std::swap(order[i - 1], order[random.next_bits() % i]);
  return order;
}

/// mean + G/n Σ (p_i − mean) over the points of each of G groups: their mean is that of all, whatever the groups' sizes.
std::vector<float> grouped(std::span<const double> parts) {
  const std::vector<std::size_t> order = shuffled(parts.size());
  const std::size_t groups = std::min(parts.size(), most_pair_parts);
  const double mean = std::accumulate(parts.begin(), parts.end(), 0.0) / static_cast<double>(parts.size());
  std::vector<double> sums(groups);
  for (std::size_t i = 0; i < parts.size(); ++i) sums[i % groups] += parts[order[i]] - mean;
  const double share = static_cast<double>(groups) / static_cast<double>(parts.size());
  std::vector<float> means;
  for (const double sum : sums) means.push_back(static_cast<float>(mean + share * sum));
  return means;
}

template <class Number>
std::vector<double> differences(const std::vector<Number>& a, const std::vector<Number>& b) {
  std::vector<double> apart(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) apart[i] = static_cast<double>(a[i]) - static_cast<double>(b[i]);
  return apart;
}

double root_of(double square) { return std::sqrt(std::max(0.0, square)); }

}  // namespace

std::optional<std::string> paired_by(const std::string& metric) {
  if (metric == "relative_rmse") return "rmse";
  return std::ranges::find(paired_metrics, metric) == paired_metrics.end() ? std::nullopt : std::optional(metric);
}

std::optional<PairTerms> pair_terms(const std::string& metric, std::span<const std::vector<Rgb>> values,
                                    const Replicas& reference) {
  GIBENCH_CHECK(paired_by(metric) == metric, "terms are kept of some metrics");
  const ValueMetric& of_values = *value_metric(*find_metric(metric));
  const HalvedReference halves(reference);
  std::vector<MetricEstimate> estimates;
  for (const std::vector<Rgb>& one : values) {
    check_finite(one, "values");
    auto estimate = of_values.estimate(one, halves.means());
    if (!estimate) return std::nullopt;
    estimates.push_back(std::move(*estimate));
  }
  SeededEstimate over = over_seeds(std::move(estimates));
  RgbDouble sum;
  for (const Rgb& value : halves.mean) sum += RgbDouble(value);
  const double mean = (sum.r + sum.g + sum.b) / (3.0 * static_cast<double>(halves.mean.size()));
  return PairTerms{over.mean.value,          halves.influences(over.mean),
                   grouped(over.mean.parts), std::move(over.values),
                   over.point_noise,         mean,
                   over.mean.correction,     over.mean.least_share};
}

PairedDifference difference_of_squares(const PairTerms& a, const PairTerms& b) {
  GIBENCH_CHECK(a.influences.size() == b.influences.size() && a.parts.size() == b.parts.size(),
                "both errors were taken against the same replicates at the same points");
  PairedDifference apart{a.value - b.value, {}};
  apart.interval = interval_over_points(apart.value, differences(a.influences, b.influences), differences(a.parts, b.parts),
                                        a.point_noise + b.point_noise);
  for (const PairTerms* one : {&a, &b}) apart.interval = widened(apart.interval, apart.value, seed_reach(one->seeds));
  apart.interval = with_weights(apart.interval, a.correction - b.correction, std::min(a.least_share, b.least_share));
  return apart;
}

std::optional<PairedDifference> difference_of(const std::string& metric, const PairTerms& a, const PairTerms& b) {
  const bool is_relative = metric == "relative_rmse";
  const auto by = paired_by(metric);
  if (!by || (is_relative && !(a.mean > 0.0))) return std::nullopt;
  const PairedDifference apart = difference_of_squares(a, b);
  if (*by != "rmse") return apart;
  const double roots = root_of(a.value) + root_of(b.value);
  const double divisor = (roots > 0.0 ? roots : 1.0) * (is_relative ? a.mean : 1.0);
  return PairedDifference{apart.value / divisor, {apart.interval.low / divisor, apart.interval.high / divisor}};
}

}  // namespace gibench
