#include "common/metrics/errors.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <string>

#include "common/metrics/automatic_exposure.h"
#include "common/metrics/intervals.h"
#include "common/metrics/metric_table.h"
#include "tests/common/metrics/noisy_references.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

using testing::ElementsAre;
using testing::Pair;
using Pixels = std::vector<Rgb>;

constexpr int width = 32, height = 24;

Pixels truth_picture() {
  Pixels pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      pixels.push_back({0.5F + 0.4F * std::sin(0.3F * static_cast<float>(x)), 0.4F, 0.3F + 0.01F * static_cast<float>(y)});
  return pixels;
}

/// The truth with pixels made larger or smaller by these factors.
Pixels wrong_picture(float even, float odd) {
  Pixels values = truth_picture();
  for (std::size_t i = 0; i < values.size(); ++i) values[i] *= i % 2 == 0 ? even : odd;
  return values;
}

/// Against an exact reference only the choice of points is uncertain, and of the largest error nothing.
Interval interval_of_points(const std::string& name, const Pixels& values, const Pixels& truth) {
  const ValueMetric& metric = *value_metric(*find_metric(name));
  const MetricEstimate estimate = metric.estimate(values, ReferenceMeans::exact(truth)).value();
  if (estimate.parts.empty()) return {estimate.value, estimate.value};
  const Interval interval = student_interval(estimate.value, estimate.parts);
  if (metric.taken != Taken::as_root_of_square) return interval;
  return {std::sqrt(interval.low), std::sqrt(interval.high)};
}

std::vector<std::string> names_of(const ErrorTable& table) {
  std::vector<std::string> names;
  for (const auto& [name, error] : table) names.push_back(name);
  return names;
}

TEST(Errors, HaveTheNamesOfTheDesign) {
  const Replicas reference = test::noisy_replicas(truth_picture(), 8, 0.01F, 1);
  EXPECT_THAT(
      names_of(value_errors(truth_picture(), reference)),
      ElementsAre("bias", "mape(0.01)", "max", "rel_mse(0.01)", "rel_mse_trim(0.1%)", "relative_rmse", "rmse", "smape(0.02)"));
  EXPECT_THAT(names_of(image_errors(width, height, truth_picture(), reference, {})),
              ElementsAre("bias", "flip", "hdr_flip", "mape(0.01)", "max", "psnr", "rel_mse(0.01)", "rel_mse_trim(0.1%)",
                          "relative_rmse", "rmse", "smape(0.02)", "ssim"));
}

TEST(Errors, AgainstAReferenceWithoutNoiseAreExact) {
  const Pixels truth = truth_picture(), values = wrong_picture(1.2F, 0.95F);
  Replicas reference;
  reference.replicas.assign(8, truth);
  const ErrorTable table = image_errors(width, height, values, reference, {});
  for (const auto& [name, exact] : exact_value_errors(values, truth)) {
    const ErrorValue& error = table.at(name);
    EXPECT_NEAR(error.value, exact, 1e-6 * std::abs(exact)) << name;
    const Interval expected = interval_of_points(name, values, truth);
    EXPECT_NEAR(error.low, expected.low, 1e-6 * std::abs(exact)) << name;
    EXPECT_NEAR(error.high, expected.high, 1e-6 * std::abs(exact)) << name;
    EXPECT_NEAR(error.noise_floor.value(), 0.0, 1e-7) << name;
    EXPECT_TRUE(error.resolved) << name;
  }
  for (const char* name : {"flip", "hdr_flip", "ssim", "psnr"}) {
    EXPECT_NEAR(table.at(name).low, table.at(name).value, 1e-5) << name;
    EXPECT_NEAR(table.at(name).high, table.at(name).value, 1e-5) << name;
  }
}

TEST(Errors, IntervalsHoldTheirValue) {
  const Pixels truth = truth_picture(), values = wrong_picture(1.15F, 0.9F);
  for (const auto& [name, error] : image_errors(width, height, values, test::noisy_replicas(truth, 8, 0.02F, 5), {})) {
    EXPECT_LE(error.low, error.value) << name;
    EXPECT_GE(error.high, error.value) << name;
    EXPECT_TRUE(error.resolved) << name;
  }
}

/// Of the metrics of pictures; those of values are in intervals_test.cpp.
TEST(Errors, IntervalsOfPicturesHoldTheTruth) {
  const Pixels truth = truth_picture(), values = wrong_picture(1.15F, 0.9F);
  Replicas exact;
  exact.replicas.assign(3, truth);
  const ErrorTable known = image_errors(width, height, values, exact, {});
  constexpr int experiments = 200;
  for (const float sigma : {0.02F, 0.1F}) {
    std::map<std::string, double> inside;
    for (int e = 0; e < experiments; ++e) {
      const Replicas noisy = test::noisy_replicas(truth, 8, sigma, static_cast<std::uint64_t>(e) + 1);
      for (const auto& [name, error] : image_errors(width, height, values, noisy, {}))
        inside[name] += error.low <= known.at(name).value && known.at(name).value <= error.high ? 1.0 / experiments : 0.0;
    }
    // 200 experiments know 95% to 1.5%; ends that allow for all of the noise hold the truth more often.
    for (const char* name : {"psnr", "ssim", "flip", "hdr_flip"}) EXPECT_GE(inside.at(name), 0.92) << name << sigma;
  }
}

TEST(Errors, OfNothingButNoiseAreBelowTheFloorOrTouchNoError) {
  const Pixels truth = truth_picture();
  const ErrorTable table = image_errors(width, height, truth, test::noisy_replicas(truth, 8, 0.1F, 5), {});
  EXPECT_FALSE(table.at("rmse").resolved);
  for (const char* name : {"flip", "hdr_flip", "mape(0.01)", "smape(0.02)"})
    EXPECT_LT(table.at(name).low, 0.5 * table.at(name).value) << name;
  EXPECT_GT(table.at("psnr").high, table.at("psnr").value + 3.0);
  EXPECT_LT(1.0 - table.at("ssim").high, 0.2 * (1.0 - table.at("ssim").value));
}

TEST(Errors, TheNoiseFloorIsAQuarterOfTheHalvesDifference) {
  const Pixels truth = truth_picture();
  for (const std::size_t count : {std::size_t{8}, std::size_t{9}}) {
    const Replicas reference = test::noisy_replicas(truth, count, 0.1F, 5);
    const Pixels a = reference.half(0), b = reference.half(1);
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
      for (int c = 0; c < 3; ++c) sum += 0.25 * std::pow(double{a[i][c]} - double{b[i][c]}, 2);
    EXPECT_NEAR(value_errors(truth, reference).at("rmse").noise_floor.value(),
                std::sqrt(sum / (3.0 * static_cast<double>(a.size()))), 1e-6);
  }
}

TEST(Errors, SmallPicturesHaveNoSsim) {
  const Pixels small(100, Rgb(0.5F));
  const Replicas reference = test::noisy_replicas(small, 8, 0.01F, 1);
  EXPECT_FALSE(image_errors(10, 10, small, reference, {}).contains("ssim"));
}

TEST(Errors, ABlackReferenceHasNoRelativeErrors) {
  const Pixels black(50, Rgb(0.0F)), values(50, Rgb(0.1F));
  Replicas reference;
  reference.replicas.assign(8, black);
  const ErrorTable table = value_errors(values, reference);
  EXPECT_FALSE(table.contains("relative_rmse"));
  EXPECT_FALSE(table.contains("bias"));
  for (const auto& [name, error] : table) EXPECT_TRUE(std::isfinite(error.value) && std::isfinite(error.high)) << name;
}

TEST(Errors, RefuseWhatTheyCannotMeasure) {
  const Pixels truth = truth_picture();
  const Replicas one = test::noisy_replicas(truth, 1, 0.01F, 1), eight = test::noisy_replicas(truth, 8, 0.01F, 1);
  const auto refused = [](const std::string& text) { return testing::ThrowsMessage<InputError>(testing::HasSubstr(text)); };
  EXPECT_THAT([&] { value_errors(truth, one); }, refused("reference: errors need two replicates at least, and it has 1"));
  Pixels broken = truth;
  broken[7].g = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THAT([&] { value_errors(broken, eight); }, refused("values[7]: is not finite"));
  EXPECT_THAT([&] { image_errors(width, height, broken, eight, {}); }, refused("values[7]: is not finite"));
  Replicas broken_reference = eight;
  broken_reference.replicas[3][2].b = std::numeric_limits<float>::infinity();
  EXPECT_THAT([&] { value_errors(truth, broken_reference); }, refused("reference[2]: is not finite"));
  EXPECT_THAT([&] { value_errors(std::span(truth).first(5), eight); }, test::fails_check("one reference value for each value"));
}

TEST(Errors, AutomaticExposureShowsTheMiddleGrey) {
  Pixels pixels(100, Rgb(4.0F));
  pixels.resize(150, Rgb(0.0F));  // black pixels do not count
  const Exposure exposure = automatic_exposure(pixels);
  EXPECT_NEAR(4.0F * std::exp2(exposure.value), 0.18F, 1e-5F);
  EXPECT_LE(exposure.start, exposure.stop);
  const Exposure black = automatic_exposure(Pixels(10, Rgb(0.0F)));
  EXPECT_TRUE(std::isfinite(black.value) && std::isfinite(black.start) && std::isfinite(black.stop));
}

TEST(Replicas, MeansHalvesVarianceAndSum) {
  Replicas set;
  set.replicas = {{Rgb(1.0F)}, {Rgb(2.0F)}, {Rgb(6.0F)}, {Rgb(7.0F)}, {Rgb(4.0F)}};
  EXPECT_EQ(set.count(), 5U);
  EXPECT_EQ(set.size(), 1U);
  EXPECT_FLOAT_EQ(set.mean()[0].r, 4.0F);
  EXPECT_FLOAT_EQ(set.half(0)[0].r, (1.0F + 6.0F + 4.0F) / 3.0F);
  EXPECT_FLOAT_EQ(set.half(1)[0].r, 4.5F);
  EXPECT_FLOAT_EQ(set.variance_of_mean()[0].g, (9.0F + 4.0F + 4.0F + 9.0F + 0.0F) / 4.0F / 5.0F);
  EXPECT_FLOAT_EQ(set.mean_without(2, 5)[0].r, 14.0F / 4.0F);
  EXPECT_FLOAT_EQ(set.mean_without(1, 2)[0].r, 11.0F / 3.0F) << "the group of replicates 1 and 3";
  const Replicas twice = Replicas::sum(set, set);
  EXPECT_EQ(twice.replicas[3][0], Rgb(14.0F));
}

}  // namespace
}  // namespace gibench
