/// Whether the 95% intervals hold the truth in 95% of simulated experiments.
#include "common/metrics/intervals.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/metrics/errors.h"
#include "common/metrics/value_metrics.h"
#include "tests/common/metrics/noisy_references.h"

namespace gibench {
namespace {

constexpr int experiments = 2000;

using Values = std::vector<Rgb>;

Values truth_values(std::size_t count) {
  Values truth;
  for (std::size_t i = 0; i < count; ++i) truth.push_back(Rgb(1.0F + 0.5F * std::sin(static_cast<float>(i)), 0.8F, 0.6F));
  return truth;
}

/// Values of a method: truth with an error of its own, alternating and biased.
Values method_values(const Values& truth, float error) {
  Values values = truth;
  for (std::size_t i = 0; i < values.size(); ++i) values[i] += Rgb(error * (0.3F + std::cos(3.0F * static_cast<float>(i))));
  return values;
}

struct Coverage {
  double inside = 0.0, mean_value = 0.0;  ///< share of the intervals that hold the truth; mean of the estimates
};

enum class Noise { normal, skewed };

Coverage coverage(const std::string& metric, const Values& truth, const Values& values, std::size_t replicas, float sigma,
                  Noise noise) {
  const double exact = exact_value_errors(values, truth).at(metric);
  Coverage result;
  for (int e = 0; e < experiments; ++e) {
    const auto seed = static_cast<std::uint64_t>(e) + 1;
    const Replicas reference = noise == Noise::normal ? test::noisy_replicas(truth, replicas, sigma, seed)
                                                      : test::skewed_replicas(truth, replicas, sigma, seed);
    const ErrorValue error = value_errors(values, reference).at(metric);
    result.inside += error.low <= exact && exact <= error.high ? 1.0 : 0.0;
    result.mean_value += error.value;
  }
  result.inside /= experiments;
  result.mean_value /= experiments;
  return result;
}

TEST(Intervals, StudentsOfAMean) {
  // Influences 1, −1, 3, −3: s² = 20 / (4 · 3), t(0.975, 3) = 3.182446.
  const std::vector<double> influences{1.0, -1.0, 3.0, -3.0};
  const Interval interval = student_interval(10.0, influences);
  EXPECT_NEAR(interval.high - 10.0, 3.182446305284 * std::sqrt(20.0 / 12.0), 1e-9);
  EXPECT_NEAR(10.0 - interval.low, 3.182446305284 * std::sqrt(20.0 / 12.0), 1e-9);
}

TEST(Intervals, DeleteOneOfAMeanIsTheMeansInterval) {
  const std::vector<double> data{3.0, 5.0, 4.0, 9.0, 1.0};
  double sum = 0.0;
  for (const double value : data) sum += value;
  std::vector<double> without, deviations;
  for (const double value : data) {
    without.push_back((sum - value) / 4.0);
    deviations.push_back(value - sum / 5.0);
  }
  EXPECT_NEAR(standard_error(delete_one_influences(without)), standard_error(deviations), 1e-12);
}

/// Errors large against the noise, of its size, and far below it; few replicates and many; an odd number of them.
struct Case {
  std::size_t replicas;
  float error, sigma;
};
class IntervalCoverage : public testing::TestWithParam<Case> {};

TEST_P(IntervalCoverage, OfSquaredErrorsIsNinetyFivePercent) {
  const Case c = GetParam();
  const Values truth = truth_values(40), values = method_values(truth, c.error);
  for (const char* metric : {"rmse", "relative_rmse"}) {
    const double inside = coverage(metric, truth, values, c.replicas, c.sigma, Noise::normal).inside;
    EXPECT_GE(inside, 0.93) << metric;
    EXPECT_LE(inside, c.error == 0.0F ? 1.0 : 0.97) << metric;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, IntervalCoverage,
                         testing::Values(Case{8, 0.2F, 0.05F}, Case{8, 0.05F, 0.1F}, Case{16, 0.1F, 0.2F}, Case{9, 0.1F, 0.1F},
                                         Case{4, 0.1F, 0.05F}, Case{2, 0.1F, 0.05F}, Case{3, 0.1F, 0.05F}));

TEST(Intervals, CoverageOfTheOtherMetrics) {
  const Values truth = truth_values(40), values = method_values(truth, 0.2F);
  for (const char* metric : {"bias", "rel_mse(0.01)", "mape(0.01)", "smape(0.02)"}) {
    const double inside = coverage(metric, truth, values, 8, 0.02F, Noise::normal).inside;
    EXPECT_GE(inside, 0.93) << metric;
    EXPECT_LE(inside, 0.97) << metric;
  }
}

TEST(Intervals, CoverageHoldsForSkewedNoise) {
  const Values truth = truth_values(200), values = method_values(truth, 0.1F);
  for (const char* metric : {"rmse", "bias"}) {
    const double inside = coverage(metric, truth, values, 8, 0.3F, Noise::skewed).inside;
    EXPECT_GE(inside, 0.93) << metric;
    EXPECT_LE(inside, 0.97) << metric;
  }
}

TEST(Intervals, TheReferencesNoiseDoesNotCountAgainstTheMethod) {
  const Values truth = truth_values(40), values = method_values(truth, 0.1F);
  const double exact = mean_squared_error(values, ReferenceMeans::exact(truth)).value;
  double mean = 0.0, against_mean = 0.0;
  for (int e = 0; e < experiments; ++e) {
    const Replicas reference = test::noisy_replicas(truth, 8, 0.2F, static_cast<std::uint64_t>(e) + 1);
    const Values r = reference.mean(), a = reference.half(0), b = reference.half(1);
    mean += mean_squared_error(values, {r, a, b}).value / experiments;
    against_mean += mean_squared_error(values, ReferenceMeans::exact(r)).value / experiments;
  }
  EXPECT_NEAR(mean, exact, 0.01 * exact);
  EXPECT_NEAR(against_mean, exact + 0.2 * 0.2 / 8.0, 0.02 * exact) << "the plain square has the noise in it";
}

TEST(Intervals, AnErrorBelowTheNoiseIsFlagged) {
  const Values truth = truth_values(400);
  const Replicas reference = test::noisy_replicas(truth, 8, 0.2F, 3);
  const ErrorTable without_error = value_errors(truth, reference),
                   with_error = value_errors(method_values(truth, 0.5F), reference);
  for (const char* metric : {"rmse", "relative_rmse", "rel_mse(0.01)", "rel_mse_trim(0.1%)"}) {
    EXPECT_TRUE(without_error.at(metric).below_noise_floor) << metric;
    EXPECT_FALSE(with_error.at(metric).below_noise_floor) << metric;
  }
  // Standard deviation of the mean of 8 replicates; 1200 numbers know it to 2%.
  EXPECT_NEAR(without_error.at("rmse").noise_floor.value(), 0.2 / std::sqrt(8.0), 0.05 * 0.2 / std::sqrt(8.0));
  EXPECT_LE(without_error.at("mape(0.01)").low, 0.3 * without_error.at("mape(0.01)").value) << "noise alone may have made it";
}

}  // namespace
}  // namespace gibench
