/// Whether intervals of a method's error cover the choice of its seed, and count its noise once.
#include "common/metrics/seeded_estimate.h"

#include <gtest/gtest.h>

#include <boost/math/distributions/binomial.hpp>
#include <cmath>

#include "common/metrics/errors.h"
#include "common/metrics/pair_terms.h"
#include "tests/common/metrics/noisy_references.h"

namespace gibench {
namespace {

using Values = std::vector<Rgb>;

constexpr int experiments = 500;

/// A method whose error is smooth, of a size that its seed draws, and noisy at every point.
struct SeededMethod {
  float error = 0.0F;
  float by_seed = 0.0F;   ///< standard deviation of the size over seeds, alike at all points
  float by_point = 0.0F;  ///< standard deviation of noise that is independent between points and seeds
};

Rgb truth_at(float u) { return {1.0F + 0.5F * std::sin(19.0F * u), 0.8F, 0.6F + 0.2F * u}; }
float shape_at(float u) { return 0.3F + std::cos(31.0F * u); }

/// Its mean squared error over seeds and points: the means of the squares of shape and sizes.
double exact_square(const SeededMethod& method) {
  constexpr int many = 100'000;
  double shape = 0.0;
  for (int i = 0; i < many; ++i) shape += std::pow(shape_at((static_cast<float>(i) + 0.5F) / many), 2) / many;
  const double e = method.error, s = method.by_seed, p = method.by_point;
  return (e * e + s * s) * shape + p * p;
}

struct Drawn {
  Values truth;
  std::vector<Values> answers;  ///< of each seed
};

Drawn drawn(const SeededMethod& method, std::size_t points, std::size_t seeds, std::uint64_t experiment) {
  Drawn all;
  std::vector<float> places;
  for (std::size_t i = 0; i < points; ++i) {
    places.push_back(RandomStream(experiment, 77, i).next_float());
    all.truth.push_back(truth_at(places.back()));
  }
  for (std::size_t k = 0; k < seeds; ++k) {
    RandomStream random(experiment, 78, k);
    const float size = method.error + method.by_seed * test::normal_number(random);
    Values& answers = all.answers.emplace_back(all.truth);
    for (std::size_t i = 0; i < points; ++i)
      for (int c = 0; c < 3; ++c) answers[i][c] += size * shape_at(places[i]) + method.by_point * test::normal_number(random);
  }
  return all;
}

struct Case {
  std::string name;
  SeededMethod method;
  std::size_t points, seeds;
};

/// The share of experiments whose interval of the rmse holds the truth.
double coverage(const Case& tried) {
  const double exact = std::sqrt(exact_square(tried.method));
  int inside = 0;
  for (int e = 1; e <= experiments; ++e) {
    const Drawn all = drawn(tried.method, tried.points, tried.seeds, static_cast<std::uint64_t>(e));
    const Replicas reference = test::noisy_replicas(all.truth, 8, 0.05F, static_cast<std::uint64_t>(e));
    const ErrorValue error = value_errors(all.answers, reference).at("rmse");
    inside += error.low <= exact && exact <= error.high ? 1 : 0;
  }
  return static_cast<double>(inside) / experiments;
}

class SeedCoverage : public testing::TestWithParam<Case> {};

TEST_P(SeedCoverage, IsNinetyFivePercent) {
  // What these experiments keep to but for one in a million.
  const boost::math::binomial counts(experiments, 0.95);
  const double share = coverage(GetParam());
  EXPECT_GE(share, boost::math::quantile(counts, 1e-6) / experiments);
}

INSTANTIATE_TEST_SUITE_P(Cases, SeedCoverage,
                         testing::Values(Case{"Alike", {0.2F, 0.0F, 0.0F}, 400, 4}, Case{"TwoSeeds", {0.1F, 0.05F, 0.0F}, 400, 2},
                                         Case{"FourSeeds", {0.1F, 0.03F, 0.0F}, 400, 4},
                                         Case{"EightSeeds", {0.1F, 0.02F, 0.05F}, 400, 8},
                                         Case{"NoiseOfPoints", {0.1F, 0.0F, 0.2F}, 400, 4},
                                         // One seed says nothing of its own spread, but noise of the points is among them.
                                         Case{"NoiseOfPointsWithOneSeed", {0.1F, 0.0F, 0.2F}, 400, 1}),
                         [](const auto& tried) { return tried.param.name; });

/// One seed alone misses the spread over seeds, which is why there is an option.
TEST(SeedCoverage, OfOneSeedMissesWhatTheSeedDraws) { EXPECT_LT(coverage({"", {0.1F, 0.03F, 0.0F}, 400, 1}), 0.8); }

/// Two methods with seeds of their own: each one's spread over seeds is among what makes the difference uncertain.
TEST(SeedCoverage, OfDifferencesIsNinetyFivePercent) {
  const SeededMethod a{0.1F, 0.03F, 0.05F}, b{0.08F, 0.02F, 0.0F};
  const double exact = exact_square(a) - exact_square(b);
  int inside = 0, without_seeds = 0;
  for (int e = 1; e <= experiments; ++e) {
    const auto experiment = static_cast<std::uint64_t>(e);
    const Drawn of_a = drawn(a, 400, 4, experiment);
    std::vector<Values> of_b(4, of_a.truth);  // at the same places, with sizes of their own
    for (std::size_t k = 0; k < of_b.size(); ++k) {
      RandomStream random(experiment, 79, k);
      const float size = b.error + b.by_seed * test::normal_number(random);
      for (std::size_t i = 0; i < of_b[k].size(); ++i)
        of_b[k][i] += Rgb(size * shape_at(RandomStream(experiment, 77, i).next_float()));
    }
    const Replicas reference = test::noisy_replicas(of_a.truth, 8, 0.05F, experiment);
    PairTerms first = pair_terms("rmse", of_a.answers, reference).value(), second = pair_terms("rmse", of_b, reference).value();
    const auto holds = [&] {
      const Interval interval = difference_of_squares(first, second).interval;
      return interval.low <= exact && exact <= interval.high ? 1 : 0;
    };
    inside += holds();
    first.seeds = second.seeds = {0.0};
    without_seeds += holds();
  }
  EXPECT_GE(inside / static_cast<double>(experiments),
            boost::math::quantile(boost::math::binomial(experiments, 0.95), 1e-6) / experiments);
  EXPECT_LT(without_seeds, 0.9 * experiments);
}

MetricEstimate estimate_of(const std::vector<double>& parts) {
  MetricEstimate estimate{0.0, Values(parts.size()), parts};
  for (const double part : parts) estimate.value += part / static_cast<double>(parts.size());
  return estimate;
}

TEST(SeededEstimate, IsTheMeanWithTheInteractionOfPointsAndSeeds) {
  const SeededEstimate over = over_seeds({estimate_of({1.0, 2.0, 6.0}), estimate_of({3.0, 2.0, 4.0})});
  EXPECT_EQ(over.values, (std::vector<double>{3.0, 3.0}));
  EXPECT_EQ(over.mean.value, 3.0);
  EXPECT_EQ(over.mean.parts, (std::vector<double>{2.0, 2.0, 5.0}));
  // Apart from the means by −1, 0, 1 and 1, 0, −1: 4 / (2 · 3 · 2 · 1).
  EXPECT_NEAR(over.point_noise, 4.0 / 12.0, 1e-15);
  const SeededEstimate alone = over_seeds({estimate_of({1.0, 2.0, 6.0})});
  EXPECT_EQ(alone.point_noise, 0.0);
  EXPECT_EQ(seed_reach(alone.values), 0.0);
  // t(0.975, 1) = 12.7062; s of 1 and 3 is 1.
  EXPECT_NEAR(seed_reach(std::vector{1.0, 3.0}), 12.70620473617471, 1e-9);
}

TEST(SeededEstimate, IntervalsWidenBySquares) {
  const Interval interval = widened({7.0, 14.0}, 10.0, 4.0);
  EXPECT_NEAR(interval.low, 5.0, 1e-12);
  EXPECT_NEAR(interval.high, 10.0 + std::sqrt(32.0), 1e-12);
}

TEST(SeededEstimate, AMethodWithoutRandomnessHasTheIntervalOfOneSeed) {
  const Drawn all = drawn({0.1F, 0.0F, 0.0F}, 500, 3, 1);
  const Replicas reference = test::noisy_replicas(all.truth, 8, 0.05F, 1);
  const ErrorTable of_three = value_errors(all.answers, reference), of_one = value_errors(all.answers.front(), reference);
  for (const auto& [metric, error] : of_one) {
    EXPECT_NEAR(of_three.at(metric).low, error.low, 1e-6 * std::abs(error.value)) << metric;
    EXPECT_NEAR(of_three.at(metric).high, error.high, 1e-6 * std::abs(error.value)) << metric;
    EXPECT_NEAR(of_three.at(metric).seed_deviation.value(), 0.0, 1e-7) << metric;
    EXPECT_FALSE(error.seed_deviation) << metric;
  }
}

TEST(SeededEstimate, PicturesCoverTheSeedToo) {
  constexpr int width = 32, height = 24;
  const Drawn all = drawn({0.05F, 0.05F, 0.05F}, width * height, 3, 5);
  const Replicas reference = test::noisy_replicas(all.truth, 8, 0.02F, 5);
  const ErrorTable over = image_errors(width, height, all.answers, reference, {});
  for (const char* metric : {"psnr", "ssim", "flip", "hdr_flip"}) {
    double mean = 0.0, narrow = 0.0;
    for (const Values& answers : all.answers) {
      const ErrorValue error = image_errors(width, height, answers, reference, {}).at(metric);
      mean += error.value / 3.0, narrow += (error.value - error.low) / 3.0;
    }
    EXPECT_NEAR(over.at(metric).value, mean, 1e-9 * std::abs(mean)) << metric;
    EXPECT_GT(over.at(metric).seed_deviation.value(), 0.0) << metric;
    const double low = metric == std::string("psnr") ? over.at(metric).low : std::max(1e-12, over.at(metric).low);
    EXPECT_GT(over.at(metric).value - low, narrow) << metric;
  }
}

}  // namespace
}  // namespace gibench
