/// Each metric on data that can be worked out by hand, and its slope against a difference quotient.
#include "common/metrics/value_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "common/core/random.h"

namespace gibench {
namespace {

using Values = std::vector<Rgb>;

TEST(ValueMetrics, OnTwoValuesByHand) {
  // Every channel alike: x = 3, 1 and r = 2, 4, so that x − r = 1, −3 and mean r = 3.
  const Values x{Rgb(3.0F), Rgb(1.0F)}, r{Rgb(2.0F), Rgb(4.0F)};
  const ReferenceMeans exact = ReferenceMeans::exact(r);
  EXPECT_DOUBLE_EQ(mean_squared_error(x, exact).value, (1.0 + 9.0) / 2.0);
  EXPECT_DOUBLE_EQ(relative_mean_squared_error(x, exact)->value, 5.0 / 9.0);
  EXPECT_DOUBLE_EQ(relative_bias(x, exact)->value, (2.0 - 3.0) / 3.0);
  EXPECT_DOUBLE_EQ(relative_squared_error(x, exact).value, (1.0 / 4.01 + 9.0 / 16.01) / 2.0);
  EXPECT_DOUBLE_EQ(mean_absolute_percentage_error(x, exact).value, (1.0 / 2.01 + 3.0 / 4.01) / 2.0);
  EXPECT_DOUBLE_EQ(symmetric_mean_absolute_percentage_error(x, exact).value, (2.0 / 5.02 + 6.0 / 5.02) / 2.0);
  EXPECT_DOUBLE_EQ(largest_error(x, exact).value, 3.0);
}

TEST(ValueMetrics, ChannelsAreAveraged) {
  const Values x{Rgb(1.0F, 2.0F, 3.0F)}, r{Rgb(1.0F, 1.0F, 1.0F)};
  EXPECT_DOUBLE_EQ(mean_squared_error(x, ReferenceMeans::exact(r)).value, (0.0 + 1.0 + 4.0) / 3.0);
  EXPECT_DOUBLE_EQ(relative_bias(x, ReferenceMeans::exact(r))->value, 1.0);
  EXPECT_DOUBLE_EQ(largest_error(x, ReferenceMeans::exact(r)).value, 2.0);
}

TEST(ValueMetrics, TheSquareIsTakenOverTheHalves) {
  const Values x{Rgb(3.0F)}, mean{Rgb(2.0F)}, a{Rgb(1.0F)}, b{Rgb(3.5F)};
  EXPECT_DOUBLE_EQ(mean_squared_error(x, {mean, a, b}).value, (3.0 - 1.0) * (3.0 - 3.5));
  EXPECT_DOUBLE_EQ(relative_squared_error(x, {mean, a, b}).value, -1.0 / 4.01);
  EXPECT_DOUBLE_EQ(mean_absolute_percentage_error(x, {mean, a, b}).value, 1.0 / 2.01) << "against the mean";
}

TEST(ValueMetrics, NoiseOnlyHasAQuarterOfTheHalvesSquaredDifference) {
  const Values mean{Rgb(2.0F), Rgb(5.0F)}, a{Rgb(1.0F), Rgb(5.5F)}, b{Rgb(3.0F), Rgb(4.5F)};
  const Values noisy = values_with_noise_only({mean, a, b});
  EXPECT_DOUBLE_EQ(mean_squared_error(noisy, ReferenceMeans::exact(mean)).value, 0.25 * (4.0 + 1.0) / 2.0);
}

TEST(ValueMetrics, BlackReferencesHaveNoRelativeError) {
  const Values x{Rgb(1.0F)}, black{Rgb(0.0F)};
  EXPECT_FALSE(relative_mean_squared_error(x, ReferenceMeans::exact(black)));
  EXPECT_FALSE(relative_bias(x, ReferenceMeans::exact(black)));
  EXPECT_NEAR(relative_squared_error(x, ReferenceMeans::exact(black)).value, 100.0, 1e-9);
  EXPECT_DOUBLE_EQ(mean_absolute_percentage_error(black, ReferenceMeans::exact(black)).value, 0.0);
}

TEST(ValueMetrics, TrimmingDropsOneInAThousand) {
  // 2999 values with the term 0.04/1.01 and one outlier each in two of them: two are dropped, of 2999 / 1000.
  Values x(2999, Rgb(1.2F)), r(2999, Rgb(1.0F));
  x[17] = Rgb(50.0F);
  x[1234] = Rgb(80.0F);
  const double term = (1.2F - 1.0F) * (1.2F - 1.0F) / 1.01;
  EXPECT_NEAR(trimmed_relative_squared_error(x, ReferenceMeans::exact(r)).value, term, 1e-7);
  x[2000] = Rgb(20.0F);  // a third one stays
  EXPECT_NEAR(trimmed_relative_squared_error(x, ReferenceMeans::exact(r)).value, (2996.0 * term + 19.0 * 19.0 / 1.01) / 2997.0,
              1e-6);
  const Values few(x.begin(), x.begin() + 999), few_r(r.begin(), r.begin() + 999);
  EXPECT_DOUBLE_EQ(trimmed_relative_squared_error(few, ReferenceMeans::exact(few_r)).value,
                   relative_squared_error(few, ReferenceMeans::exact(few_r)).value)
      << "under 1000 values nothing is left out";
}

TEST(ValueMetrics, TrimmingOfEqualErrorsKeepsTheMean) {
  const Values x(5000, Rgb(1.5F)), r(5000, Rgb(1.0F));
  EXPECT_NEAR(trimmed_relative_squared_error(x, ReferenceMeans::exact(r)).value, 0.25 / 1.01, 1e-9);
}

using Metric = std::function<MetricEstimate(const Values&, const ReferenceMeans&)>;

/// Slopes are what intervals are made from: each against (T(r + h) − T(r − h)) / 2h.
void expect_slopes(const Metric& metric, const std::string& name) {
  Values x, r;
  for (std::size_t i = 0; i < 12; ++i) {
    RandomStream random(5, 1, i);
    x.push_back({1.0F + random.next_float(), random.next_float(), -0.5F + random.next_float()});
    r.push_back({1.0F + random.next_float(), random.next_float(), -0.5F + random.next_float()});
  }
  const MetricEstimate estimate = metric(x, ReferenceMeans::exact(r));
  const float step = 0x1p-14F;
  for (std::size_t i = 0; i < r.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      Values up = r, down = r;
      up[i][c] += step;
      down[i][c] -= step;
      const double quotient = (metric(x, ReferenceMeans::exact(up)).value - metric(x, ReferenceMeans::exact(down)).value) /
                              (double{up[i][c]} - double{down[i][c]});
      const double slope = double{estimate.slope[i][c]} / (3.0 * static_cast<double>(r.size()));
      EXPECT_NEAR(slope, quotient, 2e-3 * std::abs(quotient) + 1e-5) << name << " value " << i << " channel " << c;
    }
}

TEST(ValueMetrics, SlopesAreDerivatives) {
  expect_slopes(mean_squared_error, "mse");
  expect_slopes([](const Values& x, const ReferenceMeans& r) { return relative_mean_squared_error(x, r).value(); }, "relative");
  expect_slopes([](const Values& x, const ReferenceMeans& r) { return relative_bias(x, r).value(); }, "bias");
  expect_slopes(relative_squared_error, "rel_mse");
  expect_slopes(trimmed_relative_squared_error, "rel_mse_trim");
  expect_slopes(mean_absolute_percentage_error, "mape");
  expect_slopes(symmetric_mean_absolute_percentage_error, "smape");
  expect_slopes(largest_error, "max");
}

}  // namespace
}  // namespace gibench
