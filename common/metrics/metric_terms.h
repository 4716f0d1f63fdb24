/// Sums of the terms of metrics over values and channels: what value_metrics and weighted_metrics are made from.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "common/core/error.h"
#include "common/core/parallel.h"
#include "common/core/rgb.h"
#include "common/metrics/metric_estimate.h"

namespace gibench::metric_terms {

/// Replicates are joined to so many groups at most, group g holding those of number r with r mod groups = g.
inline constexpr std::size_t most_groups = 8;

/// One term of a mean, its derivative by r and by the constant of its weight, and what of its value corrects that weight.
struct Term {
  double value, slope, by_constant = 0.0, correction = 0.0;
  std::array<double, most_groups> without = {};  ///< the value without each of the groups
};

/// A value of one channel and what the reference says of it.
struct Compared {
  double x, r, a, b;
  std::array<double, most_groups> of_groups;
  std::size_t group_count;

  std::span<const double> groups() const { return std::span(of_groups).first(group_count); }
};

/// An estimate, and its derivative by the constant of its weights.
struct Summed {
  MetricEstimate estimate;
  double by_constant = 0.0;
  std::array<double, most_groups> without{};
};

inline void check_sizes(std::span<const Rgb> values, const ReferenceMeans& reference) {
  GIBENCH_CHECK(!values.empty(), "an error needs values");
  GIBENCH_CHECK(reference.mean.size() == values.size() && reference.half_a.size() == values.size() &&
                    reference.half_b.size() == values.size() && reference.groups.size() <= most_groups,
                "one reference value for each value");
}

inline Compared compared(const Rgb& value, const ReferenceMeans& reference, std::size_t i, int channel) {
  Compared at{double{value[channel]},
              double{reference.mean[i][channel]},
              double{reference.half_a[i][channel]},
              double{reference.half_b[i][channel]},
              {},
              reference.groups.size()};
  for (std::size_t group = 0; group < at.group_count; ++group) at.of_groups[group] = double{reference.groups[group][i][channel]};
  return at;
}

/// Mean of term(i, compared) over every value and channel, summed in chunks whose order is fixed.
template <class TermOf>
Summed sum_terms(std::span<const Rgb> values, const ReferenceMeans& reference, const TermOf& term_of) {
  constexpr std::size_t chunk_size = 16384;
  check_sizes(values, reference);
  const std::size_t count = values.size();
  MetricEstimate estimate{0.0, std::vector<Rgb>(count), std::vector<double>(count)};
  struct Sum {
    double value = 0.0, by_constant = 0.0, correction = 0.0;
    std::array<double, most_groups> without{};
  };
  std::vector<Sum> sums(chunk_count(count, chunk_size));
  parallel_chunks(0, count, chunk_size, [&](const ChunkRange& range) {
    Sum sum;
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (int c = 0; c < 3; ++c) {
        const Term term = term_of(i, compared(values[i], reference, i, c));
        sum.value += term.value, sum.by_constant += term.by_constant, sum.correction += term.correction;
        for (std::size_t group = 0; group < most_groups; ++group) sum.without[group] += term.without[group];
        estimate.slope[i][c] = static_cast<float>(term.slope);
        estimate.parts[i] += term.value / 3.0;
      }
    sums[range.chunk] = sum;
  });
  Summed summed{std::move(estimate)};
  const double all = 3.0 * static_cast<double>(count);
  for (const Sum& sum : sums) {
    summed.estimate.value += sum.value / all, summed.estimate.correction += sum.correction / all;
    summed.by_constant += sum.by_constant / all;
    for (std::size_t group = 0; group < most_groups; ++group) summed.without[group] += sum.without[group] / all;
  }
  return summed;
}

inline double sign_of(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// M: over values and channels.
double mean_of(std::span<const Rgb> values);

/// Adds how the estimate moves with M, of which each r is a part.
void add_slope_of_mean(MetricEstimate& estimate, std::span<const Rgb> reference_mean, double mean, double by_mean);

}  // namespace gibench::metric_terms
