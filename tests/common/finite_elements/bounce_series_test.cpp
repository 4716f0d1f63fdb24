#include "common/finite_elements/bounce_series.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gibench {
namespace {

/// Bounces that each hold `ratio` of the one before, the first one 1.
BounceSeries geometric(const BounceBound& bound, double ratio) {
  BounceSeries series(bound);
  double last = 1.0, sum = 0.0;
  while (series.goes_on()) {
    sum += last;
    series.add(ratio, last * ratio / share_lost(ratio) / sum);
    last *= ratio;
  }
  return series;
}

TEST(BounceSeries, EndsOnceTheBouncesLeftOutHoldLittle) {
  const BounceSeries series = geometric({{}, 1000, 1e-3}, 0.5);
  EXPECT_TRUE(series.settled());
  EXPECT_TRUE(series.succeeded());
  EXPECT_EQ(series.bounces(), 10);  // the tail after n bounces is 2^-n of the whole, and 1 - 2^-n of it is summed
  EXPECT_LT(series.residual(), 1e-3);
  EXPECT_EQ(series.message(), "");
}

TEST(BounceSeries, ComputesAllBouncesOfAPlan) {
  const BounceSeries series = geometric({3, 1000, 1e-9}, 0.5);
  EXPECT_FALSE(series.settled());
  EXPECT_TRUE(series.succeeded());
  EXPECT_EQ(series.bounces(), 3);
  EXPECT_EQ(series.message(), "all 3 bounces of the plan computed");
}

TEST(BounceSeries, NamesTheParameterThatBoundsIt) {
  for (const auto& planned : {std::optional<int>(), std::optional(9)}) {
    const BounceSeries series = geometric({planned, 4, 1e-9}, 0.5);
    EXPECT_TRUE(series.succeeded());
    EXPECT_EQ(series.bounces(), 4);
    EXPECT_EQ(series.message(), "4 bounces computed, relative residual 6.67e-02; raise the parameter bounces");
  }
}

TEST(BounceSeries, WithoutAPlanLightThatDoesNotFadeFails) {
  const BounceSeries endless = geometric({{}, 8, 1e-3}, 1.0);
  EXPECT_FALSE(endless.succeeded());
  EXPECT_EQ(endless.message(), "the bounces do not fade (ratio 1.000000): the scene absorbs no light");
  EXPECT_TRUE(geometric({8, 100, 1e-3}, 1.0).succeeded());
}

TEST(BounceSeries, SettlesWhereItIsToldTo) {
  BounceSeries series({{}, 8, 0.0});
  series.add();
  EXPECT_EQ(series.next(), 2);
  series.settle();
  EXPECT_FALSE(series.goes_on());
  EXPECT_TRUE(series.succeeded());
}

TEST(BounceSeries, ProgressFollowsTheLogarithmOfTheResidual) {
  EXPECT_DOUBLE_EQ(progress_of(1e-2, 1e-4), 0.5);
  EXPECT_DOUBLE_EQ(progress_of(10.0, 1e-4), 0.0);
  EXPECT_DOUBLE_EQ(progress_of(1e-9, 1e-4), 1.0);
  EXPECT_DOUBLE_EQ(progress_of(0.0, 1e-4), 1.0);
}

}  // namespace
}  // namespace gibench
