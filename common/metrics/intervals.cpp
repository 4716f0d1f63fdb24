#include "common/metrics/intervals.h"

#include <algorithm>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <numeric>

#include "common/core/error.h"
#include "common/core/parallel.h"

namespace gibench {

namespace {

constexpr std::size_t values_per_chunk = 16384;

double mean_of(std::span<const double> values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

Interval student_interval(double value, double standard_error, std::size_t count) {
  const boost::math::students_t distribution(static_cast<double>(count) - 1.0);
  const double reach = boost::math::quantile(distribution, 0.975) * standard_error;
  return {value - reach, value + reach};
}

}  // namespace

double standard_error(std::span<const double> influences) {
  GIBENCH_CHECK(influences.size() >= 2, "an interval needs two replicates");
  const double mean = mean_of(influences), count = static_cast<double>(influences.size());
  double squares = 0.0;
  for (const double influence : influences) squares += (influence - mean) * (influence - mean);
  return std::sqrt(squares / (count * (count - 1.0)));
}

Interval student_interval(double value, std::span<const double> influences) {
  return student_interval(value, standard_error(influences), influences.size());
}

Interval interval_over_points(double value, std::span<const double> influences, std::span<const double> parts,
                              double seed_noise) {
  const double over_replicates = standard_error(influences);
  const double spread = parts.size() < 2 ? 0.0 : standard_error(parts);
  const double over_points = std::sqrt(std::max(0.0, spread * spread - seed_noise));
  return over_points > over_replicates ? student_interval(value, over_points, parts.size())
                                       : student_interval(value, over_replicates, influences.size());
}

Interval with_weights(const Interval& interval, double correction, double least_share) {
  const double low = interval.low - std::abs(correction), high = interval.high + std::abs(correction);
  return {std::min(low, least_share * low), std::max(high, least_share * high)};
}

std::vector<double> slope_influences(std::span<const Rgb> slope, const Replicas& reference, std::span<const Rgb> mean) {
  GIBENCH_CHECK(slope.size() == reference.size() && mean.size() == reference.size(), "one slope for each value");
  std::vector<double> influences(reference.count());
  const std::size_t replicas_per_chunk = std::max<std::size_t>(1, values_per_chunk / std::max<std::size_t>(1, slope.size()));
  parallel_chunks(0, influences.size(), replicas_per_chunk, [&](const ChunkRange& range) {
    for (std::size_t r = range.begin; r < range.end; ++r) {
      const std::vector<Rgb>& replica = reference.replicas[r];
      RgbDouble sum;
      for (std::size_t i = 0; i < slope.size(); ++i) sum += RgbDouble(slope[i] * (replica[i] - mean[i]));
      influences[r] = (sum.r + sum.g + sum.b) / (3.0 * static_cast<double>(slope.size()));
    }
  });
  return influences;
}

std::vector<double> delete_one_influences(std::span<const double> values_without) {
  GIBENCH_CHECK(values_without.size() >= 2, "an interval needs two replicates");
  const double mean = mean_of(values_without), others = static_cast<double>(values_without.size()) - 1.0;
  std::vector<double> influences;
  for (const double value : values_without) influences.push_back(others * (mean - value));
  return influences;
}

}  // namespace gibench
