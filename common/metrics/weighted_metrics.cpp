#include "common/metrics/weighted_metrics.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "common/metrics/metric_terms.h"

namespace gibench {

namespace {

using namespace metric_terms;

/// The constant of a weight, a share of M or of M².
struct Constant {
  double share;
  bool of_square;

  double value(double mean) const { return of_square ? share * mean * mean : share * mean; }
  double slope(double mean) const { return of_square ? 2.0 * share * mean : share; }  ///< by M
};

constexpr Constant of_squares{.share = 0.01, .of_square = true};

/// What is summed for a value, without and with weights of one group fewer.
struct Weighed {
  double plain = 0.0, fewer = 0.0;
  double by_constant = 0.0;

  /// The jackknife over the n groups of each weight.
  Term term(double n, double slope) const {
    const double correction = n > 1.0 ? (n - 1.0) * (plain - fewer) : 0.0;
    return {plain + correction, slope, by_constant, correction};
  }
};

/// 1 / (r² + c) and its parts of a sum. dw/dc = −w².
struct SquareWeight {
  double constant;
  double operator()(double r) const { return 1.0 / (r * r + constant); }
};

/// 1 / (base + |r| + c).
struct AbsoluteWeight {
  double base, constant;
  double operator()(double r) const { return 1.0 / (base + std::abs(r) + constant); }
};

/// Derivative of (x−r)² w(r) by r.
double square_slope(const Compared& at, const SquareWeight& weight) {
  const double w = weight(at.r), error = at.x - at.r;
  return -2.0 * error * w - 2.0 * at.r * error * error * w * w;
}

/// Adds (x−r_j)(x−r_k) w over the pairs, of which keeps(pair) says those that count: pairs are numbered (0,1), (0,2) … (1,2) …
template <class Keeps>
Term square_term(const Compared& at, const SquareWeight& weight, const Keeps& keeps) {
  const std::span<const double> r = at.groups();
  if (r.size() == 1) {
    const double w = weight(r[0]), square = keeps(0) ? (at.x - r[0]) * (at.x - r[0]) : 0.0;
    return {square * w, keeps(0) ? square_slope(at, weight) : 0.0, -square * w * w};
  }
  const auto count = static_cast<double>(r.size()), pairs = 0.5 * count * (count - 1.0);
  const double sum = std::accumulate(r.begin(), r.end(), 0.0);
  std::array<std::array<double, most_groups>, most_groups> square{};
  Weighed weighed;
  std::size_t pair = 0, kept = 0;
  for (std::size_t j = 0; j < r.size(); ++j)
    for (std::size_t k = j + 1; k < r.size(); ++k, ++pair) {
      if (!keeps(pair)) continue;
      ++kept;
      square[j][k] = (at.x - r[j]) * (at.x - r[k]);
      const double w = weight((sum - r[j] - r[k]) / (count - 2.0));
      weighed.plain += square[j][k] * w / pairs;
      weighed.by_constant -= square[j][k] * w * w / pairs;
    }
  if (r.size() == 3) return weighed.term(1.0, square_slope(at, weight) * static_cast<double>(kept) / pairs);
  const double left_pairs = 0.5 * (count - 1.0) * (count - 2.0);
  std::array<double, most_groups> without{};
  for (std::size_t j = 0; j < r.size(); ++j)
    for (std::size_t k = j + 1; k < r.size(); ++k)
      for (std::size_t l = k + 1; l < r.size(); ++l) {
        const double w = weight((sum - r[j] - r[k] - r[l]) / (count - 3.0)) / left_pairs;
        without[j] += square[k][l] * w, without[k] += square[j][l] * w, without[l] += square[j][k] * w;
      }
  for (const double one : without) weighed.fewer += one / count;
  Term term = weighed.term(count - 2.0, square_slope(at, weight) * static_cast<double>(kept) / pairs);
  term.without = without;
  return term;
}

double absolute_slope(const Compared& at, const AbsoluteWeight& weight) {
  const double w = weight(at.r);
  return sign_of(at.r - at.x) * w - std::abs(at.x - at.r) * sign_of(at.r) * w * w;
}

Term exact_absolute_term(const Compared& at, const AbsoluteWeight& weight) {
  const double w = weight(at.r), error = std::abs(at.x - at.r);
  return {error * w, absolute_slope(at, weight), -error * w * w};
}

Term absolute_term_at_least(const Compared& at, const AbsoluteWeight& weight) {
  const std::span<const double> r = at.groups();
  if (r.size() == 1) return exact_absolute_term(at, weight);
  const auto count = static_cast<double>(r.size());
  const double sum = std::accumulate(r.begin(), r.end(), 0.0);
  Weighed weighed;
  for (std::size_t j = 0; j < r.size(); ++j) {
    const double others = (sum - r[j]) / (count - 1.0), w = weight(others);
    const double error = sign_of(at.x - others) * (at.x - r[j]) / count;
    weighed.plain += error * w;
    weighed.by_constant -= error * w * w;
    for (std::size_t l = 0; l < r.size(); ++l)
      if (l != j) weighed.fewer += error * weight((sum - r[j] - r[l]) / (count - 2.0)) / (count - 1.0);
  }
  return weighed.term(count - 1.0, absolute_slope(at, weight));
}

/// |x−B| w(A), A of the groups first, first + 2, … and B of the others.
Term absolute_term_of_half(const Compared& at, const AbsoluteWeight& weight, std::size_t first) {
  const std::span<const double> r = at.groups();
  std::array<double, 2> sums{}, counts{};
  for (std::size_t j = 0; j < r.size(); ++j) sums[(j + first) % 2] += r[j], counts[(j + first) % 2] += 1.0;
  const double error = std::abs(at.x - sums[1] / counts[1]), w = weight(sums[0] / counts[0]);
  Weighed weighed{error * w, 0.0, -error * w * w};
  if (counts[0] > 1.0)
    for (std::size_t l = first; l < r.size(); l += 2)
      weighed.fewer += error * weight((sums[0] - r[l]) / (counts[0] - 1.0)) / counts[0];
  return weighed.term(counts[0], absolute_slope(at, weight));
}

Term absolute_term_at_most(const Compared& at, const AbsoluteWeight& weight) {
  if (at.group_count == 1) return exact_absolute_term(at, weight);
  const Term one = absolute_term_of_half(at, weight, 0), other = absolute_term_of_half(at, weight, 1);
  return {0.5 * (one.value + other.value), one.slope, 0.5 * (one.by_constant + other.by_constant),
          0.5 * (one.correction + other.correction)};
}

/// δ: the share of light in fireflies that few points have met.
double unseen_share(const ReferenceMeans& reference, double mean) {
  constexpr double mean_by_median = 1.1829;  // of |N(0, 1)|: √(2/π) over 0.67449
  std::vector<float> apart;
  apart.reserve(3 * reference.mean.size());
  double sum = 0.0;
  for (std::size_t i = 0; i < reference.mean.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      apart.push_back(0.5F * std::abs(reference.half_a[i][c] - reference.half_b[i][c]));
      sum += double{apart.back()};
    }
  const auto middle = apart.begin() + static_cast<std::ptrdiff_t>(apart.size() / 2);
  std::nth_element(apart.begin(), middle, apart.end());
  const double unseen = sum / static_cast<double>(apart.size()) - mean_by_median * double{*middle};
  return std::clamp(unseen / mean, 0.0, 1.0);
}

/// The mean of term(i, compared, the constant's value). Empty where the weights have no replicates of their own.
template <class TermOf>
std::optional<MetricEstimate> weighted_mean(std::span<const Rgb> values, const ReferenceMeans& reference,
                                            const Constant& constant, const TermOf& term_of) {
  check_sizes(values, reference);
  const double mean = mean_of(reference.mean);
  const bool has_weights = reference.groups.size() == 1 || reference.groups.size() > 2;
  if (!(mean > 0.0) || !has_weights) return std::nullopt;
  const double c = constant.value(mean);
  Summed summed = sum_terms(values, reference, [&](std::size_t i, const Compared& at) { return term_of(i, at, c); });
  add_slope_of_mean(summed.estimate, reference.mean, mean, summed.by_constant * constant.slope(mean));
  if (constant.of_square && reference.groups.size() > 3)
    summed.estimate.without_group.assign(summed.without.begin(), summed.without.begin() + std::ssize(reference.groups));
  // A weight goes with r to the power of −2 or −1 at most.
  summed.estimate.least_share = std::pow(1.0 - unseen_share(reference, mean), constant.of_square ? 2.0 : 1.0);
  return std::move(summed.estimate);
}

using AbsoluteTerm = Term (*)(const Compared&, const AbsoluteWeight&);

std::optional<MetricEstimate> percentage_error(std::span<const Rgb> values, const ReferenceMeans& reference, AbsoluteTerm term) {
  return weighted_mean(values, reference, {.share = 0.01, .of_square = false},
                       [&](std::size_t, const Compared& at, double constant) {
                         return term(at, {0.0, constant});
                       });
}

std::optional<MetricEstimate> symmetric_error(std::span<const Rgb> values, const ReferenceMeans& reference, AbsoluteTerm term) {
  return weighted_mean(values, reference, {.share = 0.02, .of_square = false},
                       [&](std::size_t, const Compared& at, double constant) {
                         const Term half = term(at, {std::abs(at.x), constant});
                         return Term{2.0 * half.value, 2.0 * half.slope, 2.0 * half.by_constant, 2.0 * half.correction};
                       });
}

/// One bit for each pair of groups: whether its value is among those kept.
using KeptPairs = std::uint32_t;
static_assert(most_groups * (most_groups - 1) / 2 <= 32);

/// Takes the bit of the pair from the values whose `error` is largest, one in a thousand.
void leave_out_largest(std::span<const double> error, std::size_t pair, std::span<KeptPairs> kept) {
  const std::size_t dropped = error.size() / 1000;
  std::vector<std::uint32_t> order(error.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto first_kept = order.begin() + static_cast<std::ptrdiff_t>(dropped);
  std::nth_element(order.begin(), first_kept, order.end(),
                   [&](std::uint32_t i, std::uint32_t j) { return error[i] != error[j] ? error[i] > error[j] : i > j; });
  std::for_each(order.begin(), first_kept, [&](std::uint32_t i) { kept[i] &= ~(KeptPairs{1} << pair); });
}

/// (x−m)² / (m² + c), averaged over the channels, m the mean of all groups but j and k.
std::vector<double> errors_without(std::span<const Rgb> values, const ReferenceMeans& reference, std::size_t j, std::size_t k) {
  const SquareWeight weight{of_squares.value(mean_of(reference.mean))};
  std::vector<double> errors(values.size());
  parallel_chunks(0, values.size(), 4096, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (int c = 0; c < 3; ++c) {
        double sum = 0.0, count = 0.0;
        for (std::size_t group = 0; group < reference.groups.size(); ++group)
          if (group != j && group != k) sum += double{reference.groups[group][i][c]}, count += 1.0;
        const double m = sum / count, error = double{values[i][c]} - m;
        errors[i] += error * error * weight(m) / 3.0;
      }
  });
  return errors;
}

/// The mean over what is kept of each pair.
std::optional<MetricEstimate> trimmed(std::span<const Rgb> values, const ReferenceMeans& reference,
                                      std::span<const KeptPairs> kept) {
  const double share = static_cast<double>(values.size() - values.size() / 1000) / static_cast<double>(values.size());
  return weighted_mean(values, reference, of_squares, [&](std::size_t i, const Compared& at, double constant) {
    Term term = square_term(at, {constant}, [&](std::size_t pair) { return ((kept[i] >> pair) & 1U) != 0; });
    for (double& one : term.without) one /= share;
    return Term{term.value / share, term.slope / share, term.by_constant / share, term.correction / share, term.without};
  });
}

constexpr KeptPairs all_pairs = ~KeptPairs{0};

}  // namespace

std::optional<MetricEstimate> relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return weighted_mean(values, reference, of_squares, [](std::size_t, const Compared& at, double constant) {
    return square_term(at, {constant}, [](std::size_t) { return true; });
  });
}

std::optional<MetricEstimate> trimmed_relative_squared_error_at_least(std::span<const Rgb> values,
                                                                      const ReferenceMeans& reference) {
  const auto whole = relative_squared_error(values, reference);
  if (!whole || values.size() < 1000) return whole;
  std::vector<KeptPairs> kept(values.size(), all_pairs), dropped_first(values.size(), 1);
  leave_out_largest(whole->parts, 0, dropped_first);
  for (std::size_t i = 0; i < kept.size(); ++i)
    if (dropped_first[i] == 0) kept[i] = 0;
  return trimmed(values, reference, kept);
}

std::optional<MetricEstimate> trimmed_relative_squared_error_at_most(std::span<const Rgb> values,
                                                                     const ReferenceMeans& reference) {
  const std::size_t count = reference.groups.size();
  if (count == 1) return trimmed_relative_squared_error_at_least(values, reference);
  if (count < 3 || values.size() < 1000 || !(mean_of(reference.mean) > 0.0)) return relative_squared_error(values, reference);
  std::vector<KeptPairs> kept(values.size(), all_pairs);
  std::size_t pair = 0;
  for (std::size_t j = 0; j < count; ++j)
    for (std::size_t k = j + 1; k < count; ++k) leave_out_largest(errors_without(values, reference, j, k), pair++, kept);
  return trimmed(values, reference, kept);
}

std::optional<MetricEstimate> percentage_error_at_least(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return percentage_error(values, reference, absolute_term_at_least);
}
std::optional<MetricEstimate> percentage_error_at_most(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return percentage_error(values, reference, absolute_term_at_most);
}

std::optional<MetricEstimate> symmetric_error_at_least(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return symmetric_error(values, reference, absolute_term_at_least);
}
std::optional<MetricEstimate> symmetric_error_at_most(std::span<const Rgb> values, const ReferenceMeans& reference) {
  return symmetric_error(values, reference, absolute_term_at_most);
}

}  // namespace gibench
