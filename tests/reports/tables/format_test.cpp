#include "reports/tables/format.h"

#include <gtest/gtest.h>

#include <cstdlib>

namespace gibench::report {
namespace {

TEST(Format, SignificantDigits) {
  EXPECT_EQ(significant(0.0), "0");
  EXPECT_EQ(significant(0.02314), "0.0231");
  EXPECT_EQ(significant(-1.5), "-1.50");
  EXPECT_EQ(significant(1234.0), "1234");
  EXPECT_EQ(significant(12.34), "12.3");
  EXPECT_EQ(significant(2.314e-7), "2.31e-07");
  EXPECT_EQ(significant(2.5e6), "2.50e+06");
}

TEST(Format, RoundingUpDoesNotAddADigit) {
  EXPECT_EQ(significant(0.9996), "1.00");
  EXPECT_EQ(significant(9.996), "10.0");
  EXPECT_EQ(significant(99.96), "100");
}

TEST(Format, Durations) {
  EXPECT_EQ(duration(0.0000123), "12.3 µs");
  EXPECT_EQ(duration(0.0123), "12.3 ms");
  EXPECT_EQ(duration(4.5), "4.50 s");
  EXPECT_EQ(duration(125.0), "2 min 5 s");
  EXPECT_EQ(duration(3720.0), "1 h 2 min");
}

TEST(Format, Counts) {
  EXPECT_EQ(large_count(512), "512");
  EXPECT_EQ(large_count(7'800'000), "7.80 M");
}

TEST(Format, ExactReadsBackTheSame) {
  for (const double value : {0.1, 1.0 / 3.0, 6.02e23, -1e-310}) EXPECT_EQ(std::strtod(exact(value).c_str(), nullptr), value);
}

TEST(Format, ErrorWithIntervalAndNotResolved) {
  const Metric percent = metric_info("relative_rmse"), plain = metric_info("flip");
  EXPECT_EQ(error_text(percent, {.value = 0.0231, .low = 0.022, .high = 0.0243, .noise_floor = 0.001}), "2.31 % [2.20, 2.43]");
  EXPECT_EQ(error_text(plain, {.value = 0.0231, .low = {}, .high = {}, .noise_floor = {}}), "0.0231");
  EXPECT_EQ(error_text(percent, {.value = 0.0004, .low = 0.0, .high = 0.002, .noise_floor = 0.004, .resolved = false}),
            "≤ 0.200 %");
  EXPECT_EQ(error_text(metric_info("bias"), {.value = 0.01, .low = -0.04, .high = 0.02, .noise_floor = 0.01, .resolved = false}),
            "≤ 4.00 %");
  EXPECT_EQ(error_text(metric_info("psnr"), {.value = 50.0, .low = 45.0, .high = 99.0, .noise_floor = 52.0, .resolved = false}),
            "≥ 45.0");
}

TEST(MetricInfo, DrawnAndRankedValues) {
  EXPECT_DOUBLE_EQ(plotted_value(metric_info("bias"), -0.02), 0.02);
  EXPECT_DOUBLE_EQ(plotted_value(metric_info("ssim"), 0.9), 1.0 - 0.9);
  EXPECT_DOUBLE_EQ(plotted_value(metric_info("psnr"), 30.0), 30.0);
  EXPECT_LT(badness(metric_info("psnr"), 40.0), badness(metric_info("psnr"), 30.0));
  EXPECT_LT(badness(metric_info("ssim"), 0.99), badness(metric_info("ssim"), 0.9));
  EXPECT_EQ(metric_info("something new").title, "something new");
}

TEST(PlottedInterval, OfABiasAroundNothingBeginsAtNothing) {
  const Metric bias = metric_info("bias");
  EXPECT_EQ(plotted_interval(bias, -0.1, 0.2), std::pair(0.0, 0.2));
  EXPECT_EQ(plotted_interval(bias, -0.3, 0.2), std::pair(0.0, 0.3));
  EXPECT_EQ(plotted_interval(bias, -0.3, -0.2), std::pair(0.2, 0.3));
  EXPECT_EQ(plotted_interval(metric_info("relative_rmse"), 0.1, 0.2), std::pair(0.1, 0.2));
}

}  // namespace
}  // namespace gibench::report
