#include "common/metrics/value_metrics.h"

#include <algorithm>
#include <array>
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

/// Whether the weights of a metric have replicates of their own; `mean` is M.
bool has_weights(const ReferenceMeans& reference, double mean) {
  return mean > 0.0 &&
         std::ranges::all_of(reference.thirds, [&](const auto& third) { return third.size() == reference.mean.size(); });
}

/// One term of a mean, its derivative by r, and by the constant of its weight.
struct Term {
  double value, slope, by_constant = 0.0;
};

/// A value of one channel and what the reference says of it.
struct Compared {
  double x, r, a, b;
  std::array<double, 3> thirds;
};

/// An estimate, and its derivative by the constant of its weights.
struct Summed {
  MetricEstimate estimate;
  double by_constant = 0.0;
};

/// Mean of term(i, compared) over every value and channel, summed in chunks whose order is fixed.
template <class TermOf>
Summed sum_terms(std::span<const Rgb> values, const ReferenceMeans& reference, const TermOf& term_of) {
  check_sizes(values, reference);
  const std::size_t count = values.size();
  MetricEstimate estimate{0.0, std::vector<Rgb>(count), std::vector<double>(count)};
  std::vector<std::array<double, 2>> sums(chunk_count(count, chunk_size));
  parallel_chunks(0, count, chunk_size, [&](const ChunkRange& range) {
    double sum = 0.0, by_constant = 0.0;
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (int c = 0; c < 3; ++c) {
        const auto third = [&](std::size_t which) {
          return reference.thirds[which].empty() ? 0.0 : double{reference.thirds[which][i][c]};
        };
        const Compared compared{double{values[i][c]},
                                double{reference.mean[i][c]},
                                double{reference.half_a[i][c]},
                                double{reference.half_b[i][c]},
                                {third(0), third(1), third(2)}};
        const Term term = term_of(i, compared);
        sum += term.value;
        by_constant += term.by_constant;
        estimate.slope[i][c] = static_cast<float>(term.slope);
        estimate.parts[i] += term.value / 3.0;
      }
    sums[range.chunk] = {sum, by_constant};
  });
  Summed summed{std::move(estimate)};
  for (const auto& [sum, by_constant] : sums) summed.estimate.value += sum, summed.by_constant += by_constant;
  summed.estimate.value /= 3.0 * static_cast<double>(count);
  summed.by_constant /= 3.0 * static_cast<double>(count);
  return summed;
}

template <class TermOf>
MetricEstimate mean_of_terms(std::span<const Rgb> values, const ReferenceMeans& reference, const TermOf& term_of) {
  return sum_terms(values, reference, term_of).estimate;
}

double mean_of(std::span<const Rgb> values) {
  RgbDouble sum;
  for (const Rgb& value : values) sum += RgbDouble(value);
  return (sum.r + sum.g + sum.b) / (3.0 * static_cast<double>(values.size()));
}

double sign_of(double x) { return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0; }

/// Adds how the estimate moves with M, of which each r is a part.
void add_slope_of_mean(MetricEstimate& estimate, std::span<const Rgb> reference_mean, double mean, double by_mean) {
  const Rgb shift(static_cast<float>(by_mean));
  for (std::size_t i = 0; i < reference_mean.size(); ++i) {
    estimate.slope[i] += shift;
    estimate.parts[i] += by_mean * (mean_of(reference_mean.subspan(i, 1)) - mean);
  }
}

/// The constant of a weight, a share of M or of M².
struct Constant {
  double share;
  bool of_square;

  double value(double mean) const { return of_square ? share * mean * mean : share * mean; }
  double slope(double mean) const { return of_square ? 2.0 * share * mean : share; }  ///< by M
};

/// The mean of term(i, compared, the constant's value). Empty where the weights have no replicates of their own.
template <class TermOf>
std::optional<MetricEstimate> weighted_mean(std::span<const Rgb> values, const ReferenceMeans& reference,
                                            const Constant& constant, const TermOf& term_of) {
  check_sizes(values, reference);
  const double mean = mean_of(reference.mean);
  if (!has_weights(reference, mean)) return std::nullopt;
  const double c = constant.value(mean);
  Summed summed = sum_terms(values, reference, [&](std::size_t i, const Compared& at) { return term_of(i, at, c); });
  add_slope_of_mean(summed.estimate, reference.mean, mean, summed.by_constant * constant.slope(mean));
  return std::move(summed.estimate);
}

/// (x−A)(x−B) / (C² + constant) over the three ways to take the thirds; the slope is that at the mean.
Term relative_squared_term(const Compared& at, double constant) {
  Term term{0.0, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = 1.0 / (at.thirds[k] * at.thirds[k] + constant);
    const double square = (at.x - at.thirds[(k + 1) % 3]) * (at.x - at.thirds[(k + 2) % 3]);
    term.value += square * weight / 3.0;
    term.by_constant -= square * weight * weight / 3.0;
  }
  const double weight = 1.0 / (at.r * at.r + constant), error = at.x - at.r;
  term.slope = -2.0 * error * weight - 2.0 * at.r * error * error * weight * weight;
  return term;
}

/// |x−B| / (base + |C| + constant), B the mean of two thirds.
Term relative_absolute_term(const Compared& at, double base, double constant) {
  Term term{0.0, 0.0};
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = 1.0 / (base + std::abs(at.thirds[k]) + constant);
    const double error = std::abs(at.x - 0.5 * (at.thirds[(k + 1) % 3] + at.thirds[(k + 2) % 3]));
    term.value += error * weight / 3.0;
    term.by_constant -= error * weight * weight / 3.0;
  }
  const double weight = 1.0 / (base + std::abs(at.r) + constant);
  term.slope = sign_of(at.r - at.x) * weight - std::abs(at.x - at.r) * sign_of(at.r) * weight * weight;
  return term;
}

constexpr Constant of_squared_errors{.share = 0.01, .of_square = true};

/// 1 for every value that the trimming keeps.
std::vector<std::uint8_t> kept_by_trimming(std::span<const Rgb> values, std::span<const Rgb> mean, double constant) {
  const std::size_t dropped = values.size() / 1000;
  std::vector<std::uint8_t> kept(values.size(), 1);
  if (dropped == 0) return kept;
  std::vector<double> error(values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      const double r = mean[i][c], error_here = values[i][c] - r;
      error[i] += error_here * error_here / (r * r + constant);
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

std::vector<Rgb> values_with_noise_only(const ReferenceMeans& reference, double factor) {
  std::vector<Rgb> values(reference.mean.begin(), reference.mean.end());
  const auto share = static_cast<float>(0.5 * factor);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += share * (reference.half_a[i] - reference.half_b[i]);
  return values;
}

MetricEstimate mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return mean_of_terms(values, reference, [](std::size_t, const Compared& at) {
    return Term{(at.x - at.a) * (at.x - at.b), -2.0 * (at.x - at.r)};
  });
}

std::optional<MetricEstimate> relative_mean_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  const double mean = mean_of(reference.mean), squared = mean * mean;
  if (!(mean > 0.0)) return std::nullopt;
  MetricEstimate estimate = mean_squared_error(values, reference);
  const auto scale = static_cast<float>(1.0 / squared);
  for (Rgb& slope : estimate.slope) slope = scale * slope;
  for (double& part : estimate.parts) part /= squared;
  add_slope_of_mean(estimate, reference.mean, mean, -2.0 * estimate.value / (squared * mean));
  estimate.value /= squared;
  return estimate;
}

std::optional<MetricEstimate> relative_bias(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  const double mean = mean_of(reference.mean), of_values = mean_of(values);
  if (!(mean > 0.0)) return std::nullopt;
  MetricEstimate estimate{(of_values - mean) / mean, std::vector<Rgb>(values.size()), std::vector<double>(values.size())};
  for (std::size_t i = 0; i < values.size(); ++i) estimate.parts[i] = mean_of(values.subspan(i, 1)) / mean - 1.0;
  add_slope_of_mean(estimate, reference.mean, mean, -of_values / (mean * mean));
  return estimate;
}

std::optional<MetricEstimate> relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return weighted_mean(values, reference, of_squared_errors,
                       [](std::size_t, const Compared& at, double constant) { return relative_squared_term(at, constant); });
}

std::optional<MetricEstimate> trimmed_relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  const double mean = mean_of(reference.mean);
  if (!has_weights(reference, mean)) return std::nullopt;
  check_sizes(values, reference);
  const std::vector<std::uint8_t> kept = kept_by_trimming(values, reference.mean, of_squared_errors.value(mean));
  const double share = static_cast<double>(values.size() - values.size() / 1000) / static_cast<double>(values.size());
  return weighted_mean(values, reference, of_squared_errors, [&](std::size_t i, const Compared& at, double constant) {
    if (kept[i] == 0) return Term{0.0, 0.0};
    const Term term = relative_squared_term(at, constant);
    return Term{term.value / share, term.slope / share, term.by_constant / share};
  });
}

std::optional<MetricEstimate> mean_absolute_percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return weighted_mean(
      values, reference, {.share = 0.01, .of_square = false},
      [](std::size_t, const Compared& at, double constant) { return relative_absolute_term(at, 0.0, constant); });
}

std::optional<MetricEstimate> symmetric_mean_absolute_percentage_error(std::span<const Rgb> values,
                                                                       const ReferenceMeans& reference) {
  return weighted_mean(values, reference, {.share = 0.02, .of_square = false},
                       [](std::size_t, const Compared& at, double constant) {
                         const Term half = relative_absolute_term(at, std::abs(at.x), constant);
                         return Term{2.0 * half.value, 2.0 * half.slope, 2.0 * half.by_constant};
                       });
}

MetricEstimate largest_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  check_sizes(values, reference);
  MetricEstimate estimate{0.0, std::vector<Rgb>(values.size()), {}};
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
