/// FLIP on pictures whose error is known or bounded, and on a small made pair whose values are pinned: they were taken when
/// the same code matched the authors' tool to 5e-4 (flip_truth_test.cpp).
#include "common/metrics/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/random.h"
#include "common/metrics/flip_colour.h"
#include "common/metrics/flip_filters.h"
#include "common/metrics/hdr_flip.h"

namespace gibench {
namespace {

using Pixels = std::vector<Rgb>;

constexpr int width = 64, height = 48;

Pixels constant(const Rgb& colour) { return Pixels(width * height, colour); }

/// A lit scene of gradients, edges and a lamp of 40; `error` adds noise, a tint and a missing shadow.
Pixels made_picture(bool error) {
  Pixels pixels;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      const auto u = static_cast<float>(x) / width, v = static_cast<float>(y) / height;
      Rgb pixel(0.1F + 0.6F * u, 0.15F + 0.5F * v, 0.3F * (1.0F - u));
      const bool in_lamp = x >= 40 && x < 48 && y < 6, in_shadow = x >= 10 && x < 24 && y >= 20 && y < 36;
      if (in_lamp) pixel = Rgb(40.0F, 34.0F, 17.0F);
      if (in_shadow) pixel *= error && x > 17 ? 0.7F : 0.15F;
      if (error) {
        RandomStream random(9, 1, static_cast<std::uint64_t>(y * width + x));
        pixel *= 0.9F + 0.2F * random.next_float();
        pixel.r *= 1.04F;
      }
      pixels.push_back(pixel);
    }
  return pixels;
}

float largest(const std::vector<float>& errors) { return *std::max_element(errors.begin(), errors.end()); }

TEST(Flip, EqualPicturesHaveNoError) {
  const Pixels picture = made_picture(true);
  EXPECT_EQ(largest(flip_map(width, height, picture, picture)), 0.0F);
  EXPECT_EQ(largest(hdr_flip_map(width, height, picture, picture, {-2.0F, 4.0F, 6})), 0.0F);
}

TEST(Flip, IsSymmetricAndInRange) {
  const Pixels a = made_picture(false), b = made_picture(true);
  const std::vector<float> errors = flip_map(width, height, a, b);
  EXPECT_EQ(errors, flip_map(width, height, b, a));
  EXPECT_GE(*std::min_element(errors.begin(), errors.end()), 0.0F);
  EXPECT_LE(largest(errors), 1.0F);
}

/// Constant pictures have no features, and the filters pass them: the error is the redistributed colour difference.
double error_of_constants(const Rgb& a, const Rgb& b) {
  const double most = std::pow(double{hyab(hunt_lab({0, 1, 0}), hunt_lab({0, 0, 1}))}, 0.7);
  const double difference = std::pow(double{hyab(hunt_lab(a), hunt_lab(b))}, 0.7), knee = 0.4 * most;
  return difference < knee ? 0.95 * difference / knee : 0.95 + 0.05 * (difference - knee) / (most - knee);
}

TEST(Flip, ConstantPicturesHaveTheErrorOfTheirColours) {
  const Rgb colours[] = {Rgb(0.0F), Rgb(1.0F), {0, 1, 0}, {0, 0, 1}, {0.2F, 0.3F, 0.4F}, {0.21F, 0.3F, 0.41F}};
  for (const Rgb& a : colours)
    for (const Rgb& b : colours) {
      const std::vector<float> errors = flip_map(width, height, constant(a), constant(b));
      for (const float error : errors) ASSERT_NEAR(error, error_of_constants(a, b), 2e-4);
    }
}

TEST(Flip, BlackAgainstWhite) {
  // L* = 0 against 100, no chroma: 100^0.7 = 25.1189; green against blue, the largest difference, is 308.1^0.7 = 41.2.
  const std::vector<float> errors = flip_map(width, height, constant(Rgb(0.0F)), constant(Rgb(1.0F)));
  EXPECT_NEAR(errors[0], 0.967417, 1e-4);
  const std::vector<float> most = flip_map(width, height, constant({0, 1, 0}), constant({0, 0, 1}));
  EXPECT_NEAR(most[0], 1.0F, 1e-4);
}

TEST(Flip, ABlobIsFoundWhereItIs) {
  const Pixels reference = constant(Rgb(0.25F));
  Pixels test = reference;
  for (int y = 20; y < 28; ++y)
    for (int x = 30; x < 38; ++x) test[static_cast<std::size_t>(y * width + x)] = {0.6F, 0.1F, 0.1F};
  const std::vector<float> errors = flip_map(width, height, reference, test);
  const auto at = [&](int x, int y) { return errors[static_cast<std::size_t>(y * width + x)]; };
  EXPECT_GT(at(34, 24), 0.5F);
  EXPECT_LT(at(5, 5), 1e-3F) << "far from the blob, beyond the filters' reach";
  EXPECT_LT(at(60, 44), 1e-3F);
}

TEST(Flip, FarAwayNothingOfAFinePatternIsSeen) {
  Pixels checkers;
  for (int i = 0; i < width * height; ++i) checkers.push_back(Rgb((i % width + i / width) % 2 == 0 ? 0.0F : 1.0F));
  const Pixels grey = constant(Rgb(0.5F));  // the same mean light
  const auto mean = [&](float ppd) { return flip_statistics(flip_map(width, height, grey, checkers, ppd)).mean; };
  EXPECT_LT(mean(120.0F), 0.25 * mean(10.0F));
}

TEST(Flip, FiltersSumAsTheyShould) {
  for (const float ppd : {20.0F, 67.0206F, 90.0F}) {
    const auto sum = [](const std::vector<float>& f) { return std::accumulate(f.begin(), f.end(), 0.0); };
    const ContrastFilters contrast = contrast_filters(ppd);
    EXPECT_NEAR(sum(contrast.luminance), 1.0, 1e-6);
    EXPECT_NEAR(sum(contrast.red_green), 1.0, 1e-6);
    EXPECT_NEAR(std::hypot(sum(contrast.blue_yellow_narrow), sum(contrast.blue_yellow_wide)), 1.0, 1e-6);
    const FeatureFilters features = feature_filters(ppd);
    EXPECT_NEAR(sum(features.gaussian), 1.0, 1e-6);
    EXPECT_NEAR(sum(features.edge), 0.0, 1e-6);
    EXPECT_NEAR(sum(features.point), 0.0, 1e-6);
  }
}

TEST(Flip, CubeRootsAreRightToTwoUnitsInTheLastPlace) {
  for (float x = 0.008F; x < 1.2F; x += 0.0007F) EXPECT_NEAR(cube_root(x), std::cbrt(x), 2.5e-7F * std::cbrt(x)) << x;
}

TEST(Flip, StatisticsByHand) {
  // Sum 2.0: running sums 0.1, 0.3, 0.6, 1.1, 2.0; over 0.5 first at 0.3, over 1.0 at 0.5, over 1.5 at 0.9.
  const std::vector<float> errors{0.5F, 0.1F, 0.9F, 0.2F, 0.3F};
  const FlipStatistics s = flip_statistics(errors);
  EXPECT_NEAR(s.mean, 0.4, 1e-7);
  EXPECT_FLOAT_EQ(static_cast<float>(s.quartile_1), 0.3F);
  EXPECT_FLOAT_EQ(static_cast<float>(s.weighted_median), 0.5F);
  EXPECT_FLOAT_EQ(static_cast<float>(s.quartile_3), 0.9F);
  EXPECT_FLOAT_EQ(static_cast<float>(s.min), 0.1F);
  EXPECT_FLOAT_EQ(static_cast<float>(s.max), 0.9F);
  EXPECT_EQ(flip_statistics(std::vector<float>(7, 0.0F)).weighted_median, 0.0);
}

TEST(HdrFlip, IsTheLargestOverTheExposures) {
  const Pixels a = made_picture(false), b = made_picture(true);
  const std::vector<float> all = hdr_flip_map(width, height, a, b, {-2.0F, 2.0F, 3});
  std::vector<float> expected(all.size(), 0.0F);
  for (const float exposure : {-2.0F, 0.0F, 2.0F}) {
    const std::vector<float> one =
        flip_map(width, height, tone_mapped(a, exposure, ToneMapper::aces), tone_mapped(b, exposure, ToneMapper::aces));
    for (std::size_t i = 0; i < one.size(); ++i) expected[i] = std::max(expected[i], one[i]);
  }
  EXPECT_EQ(all, expected);
}

TEST(HdrFlip, RangesHaveTheirExposures) {
  EXPECT_EQ((ExposureRange{-3.0F, 4.0F, 8}).exposures().size(), 8U);
  EXPECT_EQ((ExposureRange{-2.0F, 2.0F, 3}).exposures(), (std::vector<float>{-2.0F, 0.0F, 2.0F}));
  EXPECT_EQ((ExposureRange{1.5F, 1.5F, 1}).exposures(), std::vector<float>{1.5F});
  EXPECT_EQ(exposure_range(-2.2884F, 3.1557F).count, 6);
  EXPECT_EQ(exposure_range(0.0F, 0.5F).count, 2);
}

TEST(HdrFlip, AutomaticExposuresTakeTheLightestAndTheMedianTo085) {
  Pixels picture = made_picture(false);
  for (const ToneMapper mapper : {ToneMapper::aces, ToneMapper::reinhard, ToneMapper::hable}) {
    const ExposureRange range = automatic_exposures(picture, mapper);
    std::vector<float> luminances;
    for (const Rgb& pixel : picture) luminances.push_back(luminance(pixel));
    std::sort(luminances.begin(), luminances.end());
    const float median = 0.5F * (luminances[luminances.size() / 2 - 1] + luminances[luminances.size() / 2]);
    const auto shown = [&](float value, float exposure) { return tone_mapped(Pixels{Rgb(value)}, exposure, mapper)[0].g; };
    EXPECT_NEAR(shown(luminances.back(), range.start), 0.85F, 1e-4F);
    EXPECT_NEAR(shown(median, range.stop), 0.85F, 1e-4F);
  }
  const ExposureRange black = automatic_exposures(constant(Rgb(0.0F)));
  EXPECT_EQ(black.start, 0.0F);
  EXPECT_EQ(black.stop, 0.0F);
  Pixels mostly_black = constant(Rgb(0.0F));
  mostly_black[5] = Rgb(2.0F);
  EXPECT_TRUE(std::isfinite(automatic_exposures(mostly_black).stop));
}

TEST(HdrFlip, ToneMappersRiseFromBlackToWhite) {
  for (const ToneMapper mapper : {ToneMapper::aces, ToneMapper::reinhard, ToneMapper::hable}) {
    float before = -1.0F;
    for (float x = 0.0F; x < 1e30F; x = 2.0F * x + 1e-3F) {
      const float shown = tone_mapped(Pixels{Rgb(x)}, 0.0F, mapper)[0].r;
      EXPECT_GE(shown, before);
      EXPECT_LE(shown, 1.0F);
      before = shown;
    }
    EXPECT_GT(before, 0.99F);
    EXPECT_EQ(tone_mapped(Pixels{Rgb(-3.0F)}, 0.0F, mapper)[0].r, 0.0F);
  }
}

/// Quantiles are values of single pixels: another order of rounding may pick the next one.
void expect_pinned(const FlipStatistics& s, const FlipStatistics& pinned) {
  EXPECT_NEAR(s.mean, pinned.mean, 1e-5);
  EXPECT_NEAR(s.weighted_median, pinned.weighted_median, 5e-4);
  EXPECT_NEAR(s.quartile_1, pinned.quartile_1, 5e-4);
  EXPECT_NEAR(s.quartile_3, pinned.quartile_3, 5e-4);
  EXPECT_NEAR(s.min, pinned.min, 1e-4);
  EXPECT_NEAR(s.max, pinned.max, 1e-4);
}

TEST(Flip, MadePairKeepsItsValues) {
  const Pixels a = made_picture(false), b = made_picture(true);
  expect_pinned(flip_statistics(flip_map(width, height, a, b)), {0.111115, 0.104614, 0.082245, 0.370619, 0.011051, 0.842260});
  expect_pinned(flip_statistics(flip_map(width, height, a, b, 20.0F)), {0.163215, 0.177923, 0.131001, 0.242736, 0.0, 0.902448});
  expect_pinned(flip_statistics(hdr_flip_map(width, height, a, b, {-3.0F, 4.0F, 8})),
                {0.114464, 0.096968, 0.072527, 0.587479, 0.014446, 0.948550});
  expect_pinned(flip_statistics(hdr_flip_map(width, height, a, b, automatic_exposures(a))),
                {0.114080, 0.096065, 0.072504, 0.599494, 0.022987, 0.959388});
}

}  // namespace
}  // namespace gibench
