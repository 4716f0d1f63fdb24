/// Each metric on data that can be worked out by hand, and its slope against a difference quotient.
#include "common/metrics/value_metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <optional>
#include <string>

#include "common/core/random.h"
#include "common/metrics/weighted_metrics.h"

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
  EXPECT_DOUBLE_EQ(relative_squared_error(x, exact)->value, (1.0 / 4.09 + 9.0 / 16.09) / 2.0);
  EXPECT_DOUBLE_EQ(percentage_error_at_most(x, exact)->value, (1.0 / 2.03 + 3.0 / 4.03) / 2.0);
  EXPECT_DOUBLE_EQ(symmetric_error_at_most(x, exact)->value, (2.0 / 5.06 + 6.0 / 5.06) / 2.0);
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
  EXPECT_DOUBLE_EQ(mean_squared_error(x, {mean, a, b, {}}).value, (3.0 - 1.0) * (3.0 - 3.5));
}

TEST(ValueMetrics, NoUnitChangesARelativeMetric) {
  Values x, r, x_large, r_large;
  for (std::size_t i = 0; i < 1500; ++i) {
    RandomStream random(6, 1, i);
    x.push_back({random.next_float(), random.next_float(), random.next_float()});
    r.push_back({random.next_float(), 0.0F, random.next_float()});
    x_large.push_back(x.back() * 1024.0F);
    r_large.push_back(r.back() * 1024.0F);
  }
  const auto same = [&](const auto& metric) {
    EXPECT_DOUBLE_EQ(metric(x, ReferenceMeans::exact(r))->value, metric(x_large, ReferenceMeans::exact(r_large))->value);
  };
  same(relative_mean_squared_error);
  same(relative_bias);
  same(relative_squared_error);
  same(trimmed_relative_squared_error_at_most);
  same(percentage_error_at_most);
  same(symmetric_error_at_most);
}

TEST(ValueMetrics, NoiseOnlyHasAQuarterOfTheHalvesSquaredDifference) {
  const Values mean{Rgb(2.0F), Rgb(5.0F)}, a{Rgb(1.0F), Rgb(5.5F)}, b{Rgb(3.0F), Rgb(4.5F)};
  const Values noisy = values_with_noise_only({mean, a, b, {}});
  EXPECT_DOUBLE_EQ(mean_squared_error(noisy, ReferenceMeans::exact(mean)).value, 0.25 * (4.0 + 1.0) / 2.0);
}

TEST(ValueMetrics, BlackReferencesHaveNoRelativeError) {
  const Values x{Rgb(1.0F)}, black{Rgb(0.0F)};
  EXPECT_FALSE(relative_mean_squared_error(x, ReferenceMeans::exact(black)));
  EXPECT_FALSE(relative_bias(x, ReferenceMeans::exact(black)));
  EXPECT_FALSE(relative_squared_error(x, ReferenceMeans::exact(black)));
  EXPECT_FALSE(trimmed_relative_squared_error_at_most(x, ReferenceMeans::exact(black)));
  EXPECT_FALSE(percentage_error_at_most(x, ReferenceMeans::exact(black)));
  EXPECT_FALSE(symmetric_error_at_most(x, ReferenceMeans::exact(black)));
}

TEST(ValueMetrics, TrimmingDropsOneInAThousand) {
  // 2999 values with the term 0.04/1.01 and one outlier each in two of them: two are dropped, of 2999 / 1000.
  Values x(2999, Rgb(1.2F)), r(2999, Rgb(1.0F));
  x[17] = Rgb(50.0F);
  x[1234] = Rgb(80.0F);
  const double term = (1.2F - 1.0F) * (1.2F - 1.0F) / 1.01;
  EXPECT_NEAR(trimmed_relative_squared_error_at_most(x, ReferenceMeans::exact(r))->value, term, 1e-7);
  x[2000] = Rgb(20.0F);  // a third one stays
  EXPECT_NEAR(trimmed_relative_squared_error_at_most(x, ReferenceMeans::exact(r))->value,
              (2996.0 * term + 19.0 * 19.0 / 1.01) / 2997.0, 1e-6);
  const Values few(x.begin(), x.begin() + 999), few_r(r.begin(), r.begin() + 999);
  EXPECT_DOUBLE_EQ(trimmed_relative_squared_error_at_most(few, ReferenceMeans::exact(few_r))->value,
                   relative_squared_error(few, ReferenceMeans::exact(few_r))->value)
      << "under 1000 values nothing is left out";
}

TEST(ValueMetrics, TrimmingOfEqualErrorsKeepsTheMean) {
  const Values x(5000, Rgb(1.5F)), r(5000, Rgb(1.0F));
  EXPECT_NEAR(trimmed_relative_squared_error_at_most(x, ReferenceMeans::exact(r))->value, 0.25 / 1.01, 1e-9);
}

using Metric = std::function<std::optional<MetricEstimate>(const Values&, const ReferenceMeans&)>;

struct NamedMetric {
  const char* name;
  Metric metric;
};

const std::vector<NamedMetric>& metrics() {
  static const std::vector<NamedMetric> list{{"mse", mean_squared_error},
                                             {"relative", relative_mean_squared_error},
                                             {"bias", relative_bias},
                                             {"rel_mse", relative_squared_error},
                                             {"rel_mse_trim", trimmed_relative_squared_error_at_most},
                                             {"mape", percentage_error_at_most},
                                             {"smape", symmetric_error_at_most},
                                             {"max", largest_error}};
  return list;
}

struct Pairs {
  Values x, r;
};

Pairs random_pairs() {
  Pairs pairs;
  for (std::size_t i = 0; i < 12; ++i) {
    RandomStream random(5, 1, i);
    pairs.x.push_back({1.0F + random.next_float(), random.next_float(), -0.5F + random.next_float()});
    pairs.r.push_back({1.0F + random.next_float(), random.next_float(), -0.5F + random.next_float()});
  }
  return pairs;
}

/// Intervals are made from slopes: each against (T(r + h) − T(r − h)) / 2h.
TEST(ValueMetrics, SlopesAreDerivatives) {
  const auto& [x, r] = random_pairs();
  const float step = 0x1p-14F;
  for (const auto& [name, metric] : metrics()) {
    const MetricEstimate estimate = metric(x, ReferenceMeans::exact(r)).value();
    for (std::size_t i = 0; i < r.size(); ++i)
      for (int c = 0; c < 3; ++c) {
        Values up = r, down = r;
        up[i][c] += step;
        down[i][c] -= step;
        const double quotient = (metric(x, ReferenceMeans::exact(up))->value - metric(x, ReferenceMeans::exact(down))->value) /
                                (double{up[i][c]} - double{down[i][c]});
        const double slope = double{estimate.slope[i][c]} / (3.0 * static_cast<double>(r.size()));
        EXPECT_NEAR(slope, quotient, 2e-3 * std::abs(quotient) + 1e-5) << name << " value " << i << " channel " << c;
      }
  }
}

/// The mean of the parts is the value, and each is what the value moves by where its point comes once more among many.
TEST(ValueMetrics, PartsSayWhatAPointDoes) {
  const auto& [x, r] = random_pairs();
  constexpr int copies = 400;
  for (const auto& [name, metric] : metrics()) {
    const MetricEstimate estimate = metric(x, ReferenceMeans::exact(r)).value();
    if (name == std::string("max")) {
      EXPECT_TRUE(estimate.parts.empty());
      continue;
    }
    double sum = 0.0;
    for (const double part : estimate.parts) sum += part;
    EXPECT_NEAR(sum / static_cast<double>(r.size()), estimate.value, 1e-9) << name;
    if (name == std::string("rel_mse_trim")) continue;  // of so many it leaves some out
    for (std::size_t point = 0; point < r.size(); ++point) {
      Values x_more{x[point]}, r_more{r[point]};
      for (int copy = 0; copy < copies; ++copy)
        for (std::size_t i = 0; i < r.size(); ++i) x_more.push_back(x[i]), r_more.push_back(r[i]);
      const double moved = metric(x_more, ReferenceMeans::exact(r_more))->value - estimate.value;
      const double expected = (estimate.parts[point] - estimate.value) / static_cast<double>(x_more.size());
      EXPECT_NEAR(moved, expected, 0.01 * std::abs(expected) + 1e-8) << name << " point " << point;
    }
  }
}

}  // namespace
}  // namespace gibench
