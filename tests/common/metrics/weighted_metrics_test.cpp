/// What the metrics with weights give on average over references that are made again and again.
#include "common/metrics/weighted_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "common/metrics/errors.h"
#include "common/metrics/halved_reference.h"
#include "tests/common/metrics/noisy_references.h"

namespace gibench {
namespace {

using Values = std::vector<Rgb>;
using Metric = std::function<std::optional<MetricEstimate>(const Values&, const ReferenceMeans&)>;

constexpr int experiments = 2000;

Replicas replicas_of(const std::vector<float>& values) {
  Replicas set;
  for (const float value : values) set.replicas.push_back({Rgb(value)});
  return set;
}

TEST(WeightedMetrics, OfThreeReplicatesByHand) {
  // x = 4; replicates 1, 2, 3; M is 2. Errors 3, 2, 1.
  const Replicas set = replicas_of({1.0F, 2.0F, 3.0F});
  const HalvedReference reference(set);
  const Values x{Rgb(4.0F)};
  EXPECT_DOUBLE_EQ(relative_squared_error(x, reference.means())->value,
                   (3.0 * 2.0 / 9.04 + 3.0 * 1.0 / 4.04 + 2.0 * 1.0 / 1.04) / 3.0);
  // Means of the others 2.5, 2, 1.5 in the weights, and of those without one more; two of each, so that w counts twice.
  const auto w = [](double r) { return 1.0 / (r + 0.02); };
  const double plain = (3.0 * w(2.5) + 2.0 * w(2.0) + 1.0 * w(1.5)) / 3.0;
  const double fewer = (3.0 * (w(2.0) + w(3.0)) + 2.0 * (w(1.0) + w(3.0)) + 1.0 * (w(1.0) + w(2.0))) / 6.0;
  const MetricEstimate least = percentage_error_at_least(x, reference.means()).value();
  EXPECT_DOUBLE_EQ(least.value, 2.0 * plain - fewer);
  EXPECT_DOUBLE_EQ(least.correction, plain - fewer);
  // Halves 2 (of 1 and 3) and 2.
  const double corrected = 2.0 * w(2.0) - 0.5 * (w(1.0) + w(3.0));
  EXPECT_DOUBLE_EQ(percentage_error_at_most(x, reference.means())->value, 0.5 * (2.0 * corrected + 2.0 * w(2.0)));
}

TEST(WeightedMetrics, OfAnErrorWithTheNoisesSignAreNotTakenForErrors) {
  // x is the mean: every replicate is as far off on either side.
  const Replicas set = replicas_of({1.0F, 3.0F, 1.0F, 3.0F});
  const HalvedReference reference(set);
  EXPECT_LT(percentage_error_at_least(Values{Rgb(2.0F)}, reference.means())->value, 0.0);
  EXPECT_GT(percentage_error_at_most(Values{Rgb(2.0F)}, reference.means())->value, 0.0);
}

TEST(WeightedMetrics, NeedThreeReplicates) {
  const Replicas two = replicas_of({1.0F, 2.0F}), three = replicas_of({1.0F, 2.0F, 3.0F});
  const HalvedReference few(two), enough(three);
  const Values x{Rgb(4.0F)};
  for (const Metric& metric :
       {Metric(relative_squared_error), Metric(trimmed_relative_squared_error_at_least),
        Metric(trimmed_relative_squared_error_at_most), Metric(percentage_error_at_least), Metric(percentage_error_at_most),
        Metric(symmetric_error_at_least), Metric(symmetric_error_at_most)}) {
    EXPECT_FALSE(metric(x, few.means()));
    EXPECT_TRUE(metric(x, enough.means()));
  }
}

TEST(WeightedMetrics, OfManyReplicatesAreThoseOfEightGroups) {
  const Values truth(50, Rgb(1.0F)), x(50, Rgb(1.1F));
  const Replicas many = test::noisy_replicas(truth, 20, 0.1F, 1);
  Replicas joined;
  for (std::size_t group = 0; group < 8; ++group) joined.replicas.push_back(many.every(8, group));
  const HalvedReference of_many(many), of_joined(joined);
  EXPECT_NEAR(relative_squared_error(x, of_many.means())->value, relative_squared_error(x, of_joined.means())->value, 1e-6);
}

/// An exact method's estimate has the shape of every other's, so that the two can be compared.
TEST(WeightedMetrics, OfAnExactMethodGoByGroupsAsWell) {
  const Values truth(50, Rgb(1.0F));
  Replicas exact;
  exact.replicas.assign(16, truth);
  const HalvedReference reference(exact);
  EXPECT_EQ(relative_squared_error(truth, reference.means())->without_group.size(), 8U);
  EXPECT_EQ(relative_squared_error(Values(50, Rgb(1.1F)), reference.means())->without_group.size(), 8U);
}

/// The mean of a metric over references, and its standard error.
struct Mean {
  double value = 0.0, error = 0.0, correction = 0.0;
};

Mean mean_over_references(const Values& truth, const Values& values, std::size_t replicas, float sigma, const Metric& metric) {
  double sum = 0.0, squares = 0.0, correction = 0.0;
  for (int e = 0; e < experiments; ++e) {
    const Replicas set = test::noisy_replicas(truth, replicas, sigma, static_cast<std::uint64_t>(e) + 1);
    const MetricEstimate estimate = metric(values, HalvedReference(set).means()).value();
    sum += estimate.value, squares += estimate.value * estimate.value, correction += estimate.correction;
  }
  const double mean = sum / experiments;
  return {mean, std::sqrt((squares / experiments - mean * mean) / experiments), correction / experiments};
}

Values truth_of(std::size_t count) {
  Values truth;
  for (std::size_t i = 0; i < count; ++i) truth.push_back({1.0F + 0.5F * std::sin(0.3F * static_cast<float>(i)), 0.8F, 0.6F});
  return truth;
}

/// Where a weight held the noise of the error, values whose noise is downwards would count more: with errors of nothing but
/// noise, x = μ, the estimate would not have the mean 0.
TEST(WeightedMetrics, DoNotShareTheNoiseOfTheError) {
  const Values truth = truth_of(60);
  const Mean mean = mean_over_references(truth, truth, 9, 0.6F, relative_squared_error);
  EXPECT_NEAR(mean.value, 0.0, 4.0 * mean.error);
  const Mean shared =
      mean_over_references(truth, truth, 9, 0.6F, [&](const Values& x, const ReferenceMeans& of) -> MetricEstimate {
        MetricEstimate estimate;
        for (std::size_t i = 0; i < x.size(); ++i)
          for (int c = 0; c < 3; ++c) {
            const double r = of.mean[i][c], square = (x[i][c] - of.half_a[i][c]) * (x[i][c] - of.half_b[i][c]);
            estimate.value += square / (r * r + 0.01) / (3.0 * static_cast<double>(x.size()));
          }
        return estimate;
      });
  EXPECT_GT(std::abs(shared.value), 4.0 * shared.error) << "the plain weights are seen to be biased by as much noise";
}

/// E[w(m)] is off by ½ w'' σ²/n, with n = 6 and w about 1/r² by 3 σ²/(6 r²): 8% at the darkest values. The jackknife leaves the
/// square of that.
TEST(WeightedMetrics, AreCorrectedForTheNoiseOfTheirWeights) {
  const Values truth = truth_of(60);
  Values values = truth;
  for (Rgb& value : values) value *= 1.5F;
  const double exact = exact_value_errors(values, truth).at("rel_mse(0.01)");
  const Mean mean = mean_over_references(truth, values, 8, 0.2F, relative_squared_error);
  EXPECT_GT(std::abs(mean.value - mean.correction - exact), 0.02 * exact) << "without the correction";
  EXPECT_LT(std::abs(mean.value - exact), 0.25 * std::abs(mean.value - mean.correction - exact) + 4.0 * mean.error);
}

/// With δ of the light in fireflies that one value in 125 meets, every other one is darker by δ.
TEST(WeightedMetrics, AllowForFirefliesThatFewPointsMeet) {
  const Values truth(4000, Rgb(1.0F)), values(4000, Rgb(1.2F));
  const Replicas quiet = test::noisy_replicas(truth, 8, 0.2F, 1);
  const HalvedReference normal(quiet);
  // Of 12 000 half differences mean and median are known to 1% of their size, 0.056.
  EXPECT_NEAR(relative_squared_error(values, normal.means())->least_share, 1.0, 2.0 * 0.04 * 0.056);
  const Replicas flies = test::replicas_with_fireflies(truth, 8, 0.2F, 1);
  const HalvedReference rare(flies);
  // 64 fireflies of 50 in 32 000 hold a tenth of the light, known to an eighth.
  const double delta = 1.0 - std::sqrt(relative_squared_error(values, rare.means())->least_share);
  EXPECT_NEAR(delta, 0.1, 4.0 * 0.1 / 8.0);
  EXPECT_NEAR(percentage_error_at_most(values, rare.means())->least_share, 1.0 - delta, 1e-12);
}

struct Bounds {
  std::string name;
  Metric at_least, at_most;
};

/// From errors far below the noise to errors far above it: the truth is between what the two give on average.
TEST(WeightedMetrics, HaveTheTruthBetweenTheirBounds) {
  const Values truth = truth_of(1000);
  const Bounds all[] = {{"mape(0.01)", percentage_error_at_least, percentage_error_at_most},
                        {"smape(0.02)", symmetric_error_at_least, symmetric_error_at_most},
                        {"rel_mse_trim(0.1%)", trimmed_relative_squared_error_at_least, trimmed_relative_squared_error_at_most}};
  for (const float error : {0.0F, 0.02F, 0.1F, 0.5F}) {
    Values values = truth;
    RandomStream random(9, 1, 0);
    for (Rgb& value : values)
      for (int c = 0; c < 3; ++c) value[c] += error * test::normal_number(random);
    const auto exact = exact_value_errors(values, truth);
    for (const auto& [name, at_least, at_most] : all) {
      const auto mean_of = [&](const Metric& metric) {
        double sum = 0.0, squares = 0.0, correction = 0.0;
        constexpr int references = 40;
        for (int e = 0; e < references; ++e) {
          const Replicas set = test::noisy_replicas(truth, 8, 0.2F, static_cast<std::uint64_t>(e) + 1);
          const MetricEstimate estimate = metric(values, HalvedReference(set).means()).value();
          sum += estimate.value, squares += estimate.value * estimate.value;
          correction += std::abs(estimate.correction) / references;
        }
        const double mean = sum / references;
        return Mean{mean, std::sqrt(std::max(0.0, squares / references - mean * mean) / references), correction};
      };
      const Mean least = mean_of(at_least), most = mean_of(at_most);
      EXPECT_LE(least.value - least.correction, exact.at(name) + 4.0 * least.error) << name << " of errors " << error;
      EXPECT_GE(most.value + most.correction, exact.at(name) - 4.0 * most.error) << name << " of errors " << error;
    }
    // Of normal errors the root of the product is the truth, but for the different shares of the noise in the two.
    if (error > 0.05F) {
      const Replicas set = test::noisy_replicas(truth, 8, 0.2F, 1);
      EXPECT_NEAR(value_errors(values, set).at("mape(0.01)").value, exact.at("mape(0.01)"), 0.2 * exact.at("mape(0.01)"))
          << error;
    }
  }
}

}  // namespace
}  // namespace gibench
