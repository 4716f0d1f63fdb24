#include "common/metrics/value_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "common/core/error.h"
#include "common/core/parallel.h"

namespace gibench {

namespace {

constexpr std::size_t chunk_size = 16384;

void check_sizes(std::span<const Rgb> values, const ReferenceMeans& reference) {
  GIBENCH_CHECK(!values.empty(), "an error needs values");
  GIBENCH_CHECK(reference.mean.size() == values.size() && reference.half_a.size() == values.size() &&
                    reference.half_b.size() == values.size(),
                "one reference value for each value");
}

/// One term of a mean and its derivative by r.
struct Term {
  double value, slope;
};

/// Mean of term(x, r, a, b) over every value and channel, summed in chunks whose order is fixed.
template <class TermOf>
MetricEstimate mean_of_terms(std::span<const Rgb> values, const ReferenceMeans& reference, const TermOf& term_of) {
  check_sizes(values, reference);
  const std::size_t count = values.size();
  MetricEstimate estimate{0.0, std::vector<Rgb>(count)};
  std::vector<double> sums(chunk_count(count, chunk_size));
  parallel_chunks(0, count, chunk_size, [&](const ChunkRange& range) {
    double sum = 0.0;
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (int c = 0; c < 3; ++c) {
        const Term term = term_of(i, double{values[i][c]}, double{reference.mean[i][c]}, double{reference.half_a[i][c]},
                                  double{reference.half_b[i][c]});
        sum += term.value;
        estimate.slope[i][c] = static_cast<float>(term.slope);
      }
    sums[range.chunk] = sum;
  });
  estimate.value = std::accumulate(sums.begin(), sums.end(), 0.0) / (3.0 * static_cast<double>(count));
  return estimate;
}

double mean_of(std::span<const Rgb> values) {
  RgbDouble sum;
  for (const Rgb& value : values) sum += RgbDouble(value);
  return (sum.r + sum.g + sum.b) / (3.0 * static_cast<double>(values.size()));
}

double sign_of(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

Term relative_squared_term(double x, double r, double a, double b) {
  const double weight = 1.0 / (r * r + 0.01);
  const double square = (x - a) * (x - b);
  return {square * weight, -2.0 * (x - r) * weight - 2.0 * r * (x - r) * (x - r) * weight * weight};
}

/// 1 for every value that the trimming keeps.
std::vector<std::uint8_t> kept_by_trimming(std::span<const Rgb> values, std::span<const Rgb> mean) {
  const std::size_t dropped = values.size() / 1000;
  std::vector<std::uint8_t> kept(values.size(), 1);
  if (dropped == 0) return kept;
  std::vector<double> error(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double x = values[i][c], r = mean[i][c];
      error[i] += relative_squared_term(x, r, r, r).value;
    }
  std::vector<std::size_t> order(values.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto first_kept = order.begin() + static_cast<std::ptrdiff_t>(dropped);
  std::nth_element(order.begin(), first_kept, order.end(),
                   [&](std::size_t i, std::size_t j) { return error[i] != error[j] ? error[i] > error[j] : i > j; });
  std::for_each(order.begin(), first_kept, [&](std::size_t i) { kept[i] = 0; });
  return kept;
}

}  // namespace

std::vector<Rgb> values_with_noise_only(const ReferenceMeans& reference) {
  std::vector<Rgb> values(reference.mean.begin(), reference.mean.end());
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += 0.5F * (reference.half_a[i] - reference.half_b[i]);
  return values;
}

MetricEstimate mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return mean_of_terms(values, reference, [](std::size_t, double x, double r, double a, double b) {
    return Term{(x - a) * (x - b), -2.0 * (x - r)};
  });
}

std::optional<MetricEstimate> relative_mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  const double mean = mean_of(reference.mean);
  if (!(mean > 0.0)) return std::nullopt;
  MetricEstimate estimate = mean_squared_error(values, reference);
  const auto scale = static_cast<float>(1.0 / (mean * mean));
  const auto shift = static_cast<float>(-2.0 * estimate.value / (mean * mean * mean));
  for (Rgb& slope : estimate.slope) slope = scale * slope + Rgb(shift);
  estimate.value /= mean * mean;
  return estimate;
}

std::optional<MetricEstimate> relative_bias(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  const double mean = mean_of(reference.mean), of_values = mean_of(values);
  if (!(mean > 0.0)) return std::nullopt;
  const auto slope = static_cast<float>(-of_values / (mean * mean));
  return MetricEstimate{(of_values - mean) / mean, std::vector<Rgb>(values.size(), Rgb(slope))};
}

MetricEstimate relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return mean_of_terms(values, reference,
                       [](std::size_t, double x, double r, double a, double b) { return relative_squared_term(x, r, a, b); });
}

MetricEstimate trimmed_relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  const std::vector<std::uint8_t> kept = kept_by_trimming(values, reference.mean);
  const double share = static_cast<double>(values.size() - values.size() / 1000) / static_cast<double>(values.size());
  return mean_of_terms(values, reference, [&](std::size_t i, double x, double r, double a, double b) {
    if (kept[i] == 0) return Term{0.0, 0.0};
    const Term term = relative_squared_term(x, r, a, b);
    return Term{term.value / share, term.slope / share};
  });
}

MetricEstimate mean_absolute_percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return mean_of_terms(values, reference, [](std::size_t, double x, double r, double, double) {
    const double weight = 1.0 / (std::abs(r) + 0.01), error = std::abs(x - r);
    return Term{error * weight, sign_of(r - x) * weight - error * sign_of(r) * weight * weight};
  });
}

MetricEstimate symmetric_mean_absolute_percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return mean_of_terms(values, reference, [](std::size_t, double x, double r, double, double) {
    const double weight = 1.0 / (std::abs(x) + std::abs(r) + 0.02), error = std::abs(x - r);
    return Term{2.0 * error * weight, 2.0 * (sign_of(r - x) * weight - error * sign_of(r) * weight * weight)};
  });
}

MetricEstimate largest_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  MetricEstimate estimate{0.0, std::vector<Rgb>(values.size())};
  std::size_t place = 0;
  int channel = 0;
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double error = std::abs(double{values[i][c]} - double{reference.mean[i][c]});
      if (error > estimate.value) estimate.value = error, place = i, channel = c;
    }
  estimate.slope[place][channel] = 3.0F * static_cast<float>(values.size()) *
                                   static_cast<float>(sign_of(reference.mean[place][channel] - values[place][channel]));
  return estimate;
}

}  // namespace gibench
