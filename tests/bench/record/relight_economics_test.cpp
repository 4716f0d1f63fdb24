/// What a relit frame is worth, by hand-made numbers.
#include "bench/record/relight_economics.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/core/error.h"
#include "common/core/random.h"

namespace gibench {
namespace {

using testing::Optional;

ErrorValue error(double value, double low, double high) { return {value, low, high, 0.001, true}; }

TEST(PathTracingSeconds, FallWithTheSquareOfTheError) {
  const PathTraced traced{8.0, 0.02, 512.0};
  const Bounded seconds = path_tracing_seconds(traced, error(0.04, 0.02, 0.08));
  EXPECT_THAT(seconds.value, Optional(2.0));
  EXPECT_THAT(seconds.low, Optional(0.5)) << "the largest error takes the least time";
  EXPECT_THAT(seconds.high, Optional(8.0));
}

/// The law that it stands on, tried out: the mean of n draws has the standard error σ/√n.
TEST(PathTracingSeconds, AreThoseThatMeansOfDrawsNeed) {
  constexpr int repeats = 4000;
  const auto spread_of_means = [](int draws) {
    double sum = 0.0;
    for (std::uint64_t r = 0; r < repeats; ++r) {
      RandomStream random(1, static_cast<std::uint64_t>(draws), r);
      double mean = 0.0;
      for (int i = 0; i < draws; ++i) mean += (static_cast<double>(random.next_float()) - 0.5) / draws;
      sum += mean * mean;
    }
    return std::sqrt(sum / repeats);
  };
  const PathTraced traced{64.0, spread_of_means(64), 64.0};  // a second a draw
  const Bounded seconds = path_tracing_seconds(traced, error(spread_of_means(16), 1.0, 1.0));
  // A variance of 4000 squares is known to √(2/4000) = 2.2%; a ratio of two to 3.2%; four of those.
  EXPECT_NEAR(*seconds.value, 16.0, 16.0 * 4 * 0.032);
}

TEST(PathTracingSeconds, AreAtLeastThoseOfOnePath) {
  const PathTraced traced{8.0, 0.02, 16.0};
  EXPECT_THAT(path_tracing_seconds(traced, error(1.0, 1.0, 1.0)).value, Optional(0.5));
}

TEST(PathTracingSeconds, GrowWithThePointsThatAreAsked) {
  const PathTraced many = at_as_many_points({8.0, 0.02, 512.0}, 100, 3000);
  EXPECT_DOUBLE_EQ(many.seconds, 240.0);
  EXPECT_EQ(many.rmse, 0.02);
  EXPECT_EQ(many.paths, 512.0);
}

TEST(PathTracingSeconds, OfAnErrorThatIsNotResolvedHaveALowerBoundAlone) {
  const PathTraced traced{8.0, 0.02, 512.0};
  const Bounded seconds = path_tracing_seconds(traced, {0.005, 0.0, 0.02, 0.04, false});
  EXPECT_EQ(seconds.value, std::nullopt);
  EXPECT_THAT(seconds.low, Optional(8.0)) << "that of an error as large as the interval allows";
  EXPECT_EQ(seconds.high, std::nullopt);
}

TEST(PathTracingSeconds, HaveNoUpperEndWhereTheErrorMayVanish) {
  const Bounded seconds = path_tracing_seconds({8.0, 0.02, 512.0}, error(0.04, 0.0, 0.08));
  EXPECT_THAT(seconds.value, Optional(2.0));
  EXPECT_EQ(seconds.high, std::nullopt);
}

TEST(TimesCheaper, AreNotKnownForAFrameThatTheClockDoesNotResolve) {
  EXPECT_THAT(times_cheaper({2.0, 1.0, 4.0}, 0.5).value, Optional(4.0));
  EXPECT_FALSE(times_cheaper({2.0, 1.0, 4.0}, 0.0).value);
}

TEST(FramesThatPay, AreTheLeastWithWhichPreparingPays) {
  // 10 + 0.1 n ≤ 2.1 n from n = 5 on.
  const Bounded frames = frames_that_pay(10.0, 0.1, {2.1, 0.6, 10.1});
  EXPECT_THAT(frames.value, Optional(5.0));
  EXPECT_THAT(frames.low, Optional(1.0));
  EXPECT_THAT(frames.high, Optional(20.0));
}

TEST(FramesThatPay, AreNotKnownWherePathTracingMayBeAsFast) {
  const Bounded frames = frames_that_pay(10.0, 0.1, {2.1, 0.1, {}});
  EXPECT_THAT(frames.value, Optional(5.0));
  EXPECT_EQ(frames.high, std::nullopt);
  EXPECT_EQ(frames.low, std::nullopt);
  EXPECT_EQ(frames_that_pay(10.0, 0.1, {0.05, 0.04, 0.06}).value, std::nullopt) << "never";
}

TEST(Medians, TakeWhatIsAbsentAsLarger) {
  const Bounded known{1.0, 0.5, 2.0}, hidden{{}, 3.0, {}};
  const std::vector<Bounded> mostly_known{known, hidden, known}, mostly_hidden{hidden, known, hidden};
  EXPECT_THAT(median_of(mostly_known).value, Optional(1.0));
  EXPECT_THAT(median_of(mostly_known).low, Optional(0.5));
  EXPECT_EQ(median_of(mostly_hidden).value, std::nullopt);
  EXPECT_THAT(median_of(mostly_hidden).low, Optional(3.0));
}

}  // namespace
}  // namespace gibench
