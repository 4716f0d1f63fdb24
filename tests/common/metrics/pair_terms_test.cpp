/// Whether the intervals of differences between two methods hold the true difference in 95% of simulated experiments.
#include "common/metrics/pair_terms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>
#include <functional>
#include <string>

#include "common/metrics/errors.h"
#include "common/metrics/value_metrics.h"
#include "tests/common/metrics/noisy_references.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

constexpr int experiments = 2000;

using Values = std::vector<Rgb>;

/// Two methods at a place u in [0, 1): what they answer differs from the truth by smooth errors of these sizes, alike in shape.
struct Methods {
  float error_a = 0.0F, error_b = 0.0F;
  float noise_a = 0.0F;  ///< standard deviation of a's own noise, independent between points
  float apart = 0.5F;    ///< radians by which b's error is shifted against a's

  static Rgb truth(float u) { return {1.0F + 0.5F * std::sin(19.0F * u), 0.8F, 0.6F + 0.2F * u}; }
  Rgb a(float u) const { return truth(u) + Rgb(error_a * (0.3F + std::cos(31.0F * u))); }
  Rgb b(float u) const { return truth(u) + Rgb(error_b * (0.3F + std::cos(31.0F * u + apart))); }
};

struct Compared {
  Values truth, a, b;

  template <class PlaceOf>
  Compared(const Methods& methods, std::size_t count, const PlaceOf& place_of) {
    for (std::size_t i = 0; i < count; ++i) {
      const float u = place_of(i);
      truth.push_back(Methods::truth(u)), a.push_back(methods.a(u)), b.push_back(methods.b(u));
    }
  }
};

/// Square of a minus that of b at so many places that their choice does not matter; a's own noise adds its variance, weighed.
double exact_difference(const Methods& methods, const std::string& metric) {
  constexpr std::size_t many = 100'000;
  const Compared all(methods, many, [](std::size_t i) { return (static_cast<float>(i) + 0.5F) / static_cast<float>(many); });
  Values noisy = all.truth;
  for (std::size_t i = 0; i < many; ++i) noisy[i] += Rgb(methods.noise_a);
  const auto square = [&](const Values& values) {
    const double error = exact_value_errors(values, all.truth).at(metric);
    return metric == "rmse" ? error * error : error;
  };
  return square(all.a) - square(all.b) + square(noisy);
}

enum class Noise { normal, skewed, fireflies };

struct Experiment {
  std::string name;
  Methods methods;
  std::size_t points, replicas;
  float sigma;
  Noise noise = Noise::normal;
};

Replicas reference_of(const Experiment& experiment, const Values& truth, std::uint64_t seed) {
  switch (experiment.noise) {
    case Noise::normal: return test::noisy_replicas(truth, experiment.replicas, experiment.sigma, seed);
    case Noise::skewed: return test::skewed_replicas(truth, experiment.replicas, experiment.sigma, seed);
    case Noise::fireflies: return test::replicas_with_fireflies(truth, experiment.replicas, experiment.sigma, seed);
  }
  return {};
}

/// Calls use(terms of a, terms of b) for each experiment: points, reference and a's noise are drawn anew each time.
using Use = std::function<void(const PairTerms&, const PairTerms&)>;
void repeat(const Experiment& experiment, const std::string& metric, const Use& use) {
  for (int e = 0; e < experiments; ++e) {
    const auto seed = static_cast<std::uint64_t>(e) + 1;
    Compared drawn(experiment.methods, experiment.points, [&](std::size_t i) { return RandomStream(seed, 77, i).next_float(); });
    RandomStream random(seed, 78, 0);
    for (Rgb& value : drawn.a)
      for (int c = 0; c < 3; ++c) value[c] += experiment.methods.noise_a * test::normal_number(random);
    const Replicas reference = reference_of(experiment, drawn.truth, seed);
    use(pair_terms(metric, std::vector<Values>{drawn.a}, reference).value(),
        pair_terms(metric, std::vector<Values>{drawn.b}, reference).value());
  }
}

/// The share that a count of 2000 keeps to but for one in a million, where each happens with this chance.
double least_share(double chance) {
  return boost::math::quantile(boost::math::binomial(experiments, chance), 1e-6) / experiments;
}
double largest_share(double chance) {
  return boost::math::quantile(boost::math::complement(boost::math::binomial(experiments, chance), 1e-6)) / experiments;
}

/// Of the variances over replicates and over points the larger one counts. Where the reference's noise is all there is, both have
/// one mean: with q = χ²/(R−1) of the replicates the interval holds the truth in 95% where q < 1 and in P(|z| < t √q) elsewhere,
/// on the whole in 96.6% for 8 replicates and in 96.8% for 3.
constexpr double at_most = 0.97;

class PairedCoverage : public testing::TestWithParam<Experiment> {};

TEST_P(PairedCoverage, IsNinetyFivePercent) {
  for (const char* metric : paired_metrics) {
    const double exact = exact_difference(GetParam().methods, metric);
    int inside = 0;
    repeat(GetParam(), metric, [&](const PairTerms& a, const PairTerms& b) {
      const Interval interval = difference_of_squares(a, b).interval;
      inside += interval.low <= exact && exact <= interval.high ? 1 : 0;
    });
    const double share = static_cast<double>(inside) / experiments;
    EXPECT_GE(share, least_share(0.95)) << metric;
    if (metric == std::string("rmse")) {
      EXPECT_LE(share, largest_share(at_most));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, PairedCoverage,
                         testing::Values(Experiment{"LargeErrors", {0.2F, 0.15F}, 400, 8, 0.05F},
                                         Experiment{"Alike", {0.1F, 0.1F}, 400, 8, 0.1F},
                                         Experiment{"BelowTheNoise", {0.04F, 0.03F}, 400, 8, 0.3F},
                                         Experiment{"FewPoints", {0.2F, 0.1F}, 60, 8, 0.1F},
                                         Experiment{"FewReplicates", {0.1F, 0.05F}, 200, 3, 0.1F},
                                         Experiment{"ManyPoints", {0.1F, 0.08F}, 3000, 8, 0.2F},
                                         Experiment{"OwnNoise", {0.05F, 0.1F, 0.1F}, 400, 8, 0.1F},
                                         Experiment{"Skewed", {0.1F, 0.05F}, 400, 8, 0.3F, Noise::skewed},
                                         Experiment{"Fireflies", {0.1F, 0.05F}, 400, 8, 0.2F, Noise::fireflies},
                                         Experiment{"FirefliesAlike", {0.1F, 0.1F}, 400, 8, 0.2F, Noise::fireflies}),
                         [](const auto& experiment) { return experiment.param.name; });

/// What both errors share hides the difference: the intervals of the errors overlap nearly always.
TEST(PairTerms, TellApartWhatTheIntervalsOfErrorsDoNot) {
  int told_apart = 0, by_own_intervals = 0;
  repeat({"", {0.2F, 0.19F, 0.0F, 0.0F}, 400, 8, 0.05F}, "rmse", [&](const PairTerms& a, const PairTerms& b) {
    told_apart += difference_of_squares(a, b).told_apart() ? 1 : 0;
    const auto interval = [](const PairTerms& terms) {
      const std::vector<double> parts(terms.parts.begin(), terms.parts.end());
      return interval_over_points(terms.value, terms.influences, parts);
    };
    by_own_intervals += interval(a).low > interval(b).high || interval(b).low > interval(a).high ? 1 : 0;
  });
  EXPECT_GT(told_apart, 9 * experiments / 10);
  EXPECT_LT(by_own_intervals, experiments / 10);
}

TEST(PairTerms, KeepTheMeanAndTheSpreadOfManyPoints) {
  constexpr std::size_t points = 5000;
  Values truth(points, Rgb(0.5F)), values = truth;
  RandomStream random(3, 1, 0);
  for (Rgb& value : values) value += Rgb(0.1F * test::normal_number(random));
  const Replicas reference = test::noisy_replicas(truth, 8, 0.01F, 1);
  const PairTerms terms = pair_terms("rmse", std::vector<Values>{values}, reference).value();
  ASSERT_EQ(terms.parts.size(), most_pair_parts);
  const std::vector<double> parts(terms.parts.begin(), terms.parts.end());
  double mean = 0.0;
  for (const double part : parts) mean += part / static_cast<double>(parts.size());
  EXPECT_NEAR(mean, terms.value, 1e-6 * terms.value);
  const MetricEstimate whole = mean_squared_error(values, ReferenceMeans::exact(truth));
  // Of normal parts a standard error from 1024 groups is known to 1/√2048; squares in fives have twice the spread of its square.
  EXPECT_NEAR(standard_error(parts) / standard_error(whole.parts), 1.0, 4.0 * std::sqrt(2.0 / 2048.0));
}

TEST(PairTerms, OfRootsHaveTheSignOfTheSquares) {
  const PairTerms large{0.09, {0.001, -0.001, 0.0}, {0.08F, 0.10F, 0.09F}, {0.09}, 0.0, 2.0, 0.0, 1.0};
  const PairTerms small{0.01, {0.001, -0.001, 0.0}, {0.009F, 0.011F, 0.01F}, {0.01}, 0.0, 2.0, 0.0, 1.0};
  const PairTerms none{-0.001, {0.0, 0.0, 0.0}, {-0.001F, -0.001F, -0.001F}, {-0.001}, 0.0, 2.0, 0.0, 1.0};
  const PairedDifference squares = difference_of_squares(large, small), roots = difference_of("rmse", large, small).value();
  EXPECT_NEAR(squares.value, 0.08, 1e-12);
  EXPECT_NEAR(roots.value, 0.3 - 0.1, 1e-12);
  EXPECT_NEAR(roots.interval.low, squares.interval.low / 0.4, 1e-12);
  EXPECT_NEAR(roots.interval.high, squares.interval.high / 0.4, 1e-12);
  EXPECT_TRUE(roots.told_apart());
  EXPECT_NEAR(difference_of("relative_rmse", large, small)->value, 0.1, 1e-12);
  EXPECT_LT(difference_of("rmse", none, small)->value, 0.0);
  EXPECT_FALSE(difference_of("rmse", none, none)->told_apart());
}

TEST(PairTerms, RefuseWhatCannotBePaired) {
  PairTerms terms{0.1, {0.0, 0.0}, {0.1F, 0.1F}, {0.1}, 0.0, 1.0, 0.0, 1.0};
  const PairTerms fewer{0.1, {0.0, 0.0}, {0.1F}, {0.1}, 0.0, 1.0, 0.0, 1.0};
  for (const char* metric : {"mape(0.01)", "rel_mse_trim(0.1%)", "bias", "flip", "unknown"}) {
    EXPECT_FALSE(paired_by(metric)) << metric;
    EXPECT_FALSE(difference_of(metric, terms, terms)) << metric;
  }
  EXPECT_THAT([&] { difference_of("rmse", terms, fewer); }, test::fails_check("same points"));
  terms.mean = 0.0;
  EXPECT_TRUE(difference_of("rmse", terms, terms));
  EXPECT_FALSE(difference_of("relative_rmse", terms, terms)) << "of a black reference";
  const Values black{Rgb(0.0F)};
  Replicas reference;
  reference.replicas.assign(8, black);
  EXPECT_FALSE(pair_terms("rel_mse(0.01)", std::vector<Values>{black}, reference));
}

/// A difference of relative squares is that of the terms, and what the weights' noise may still make of it widens the interval.
TEST(PairTerms, OfRelativeSquaresAreAsFarApartAsTheyAre) {
  const PairTerms a{0.3, {0.01, -0.01, 0.0}, {0.3F, 0.3F, 0.3F}, {0.3}, 0.0, 2.0, 0.02, 1.0};
  const PairTerms b{0.2, {0.01, -0.01, 0.0}, {0.2F, 0.2F, 0.2F}, {0.2}, 0.0, 2.0, 0.005, 0.9};
  const PairedDifference apart = difference_of("rel_mse(0.01)", a, b).value();
  EXPECT_NEAR(apart.value, 0.1, 1e-12);
  EXPECT_NEAR(apart.interval.low, 0.9 * (0.1 - 0.015), 1e-6);
  EXPECT_NEAR(apart.interval.high, 0.1 + 0.015, 1e-6);
}

}  // namespace
}  // namespace gibench
