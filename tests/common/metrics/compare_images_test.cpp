#include "common/metrics/compare_images.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/core/error.h"

namespace gibench {
namespace {

using testing::HasSubstr;

ImageFile picture(bool high_dynamic_range, float scale) {
  ImageFile file;
  file.high_dynamic_range = high_dynamic_range;
  file.image = {24, 16, {}};
  for (int i = 0; i < 24 * 16; ++i) file.image.pixels.push_back(scale * Rgb(0.1F + 0.002F * static_cast<float>(i), 0.3F, 0.2F));
  return file;
}

std::string refusal(const ImageFile& reference, const ImageFile& test, const ComparisonOptions& options = {}) {
  try {
    compare_images(reference, "ref.exr", test, "test.exr", options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

TEST(CompareImages, EqualPicturesDifferInNothing) {
  for (const bool high : {false, true}) {
    const ImageComparison same = compare_images(picture(high, 1.0F), "a", picture(high, 1.0F), "b", {});
    EXPECT_EQ(same.flip_name, high ? "hdr_flip" : "flip");
    EXPECT_EQ(same.flip.max, 0.0);
    EXPECT_EQ(same.values.at("rmse"), 0.0);
    EXPECT_EQ(same.values.at("ssim"), 1.0);
    EXPECT_EQ(same.values.at("psnr"), 100.0);
    EXPECT_EQ(same.values.size(), 10U);
  }
}

TEST(CompareImages, ValuesAtTheEndOfFloatAreShownAsAnyOthers) {
  // What is shown, and so every metric of it, does not depend on the unit: the exposure follows the reference.
  ImageFile test = picture(true, 0.5F);
  std::ranges::reverse(test.image.pixels);
  const ImageComparison plain = compare_images(picture(true, 1.0F), "a", test, "b", {});
  EXPECT_LT(plain.values.at("psnr"), 30.0);
  for (const int stops : {-100, 100, 124, 126, 127}) {
    const auto scaled = [&](ImageFile file) {
      for (Rgb& pixel : file.image.pixels) pixel *= std::ldexp(1.0F, stops);
      return file;
    };
    const ImageComparison same = compare_images(scaled(picture(true, 1.0F)), "a", scaled(test), "b", {});
    EXPECT_NEAR(same.values.at("psnr"), plain.values.at("psnr"), 1e-4) << stops;
    EXPECT_NEAR(same.values.at("ssim"), plain.values.at("ssim"), 1e-4) << stops;
    EXPECT_NEAR(same.flip.mean, plain.flip.mean, 1e-4) << stops;
    EXPECT_NEAR(same.flip.max, plain.flip.max, 1e-4) << stops;
  }
}

TEST(CompareImages, APictureOfTheLargestFloatsIsNotThatOfItsHalf) {
  ImageFile reference = picture(true, 1.0F), test = reference;
  std::ranges::fill(reference.image.pixels, Rgb(std::numeric_limits<float>::max()));
  std::ranges::fill(test.image.pixels, Rgb(0.3F * std::numeric_limits<float>::max()));
  const ImageComparison compared = compare_images(reference, "a", test, "b", {});
  EXPECT_LT(compared.values.at("psnr"), 20.0);
  EXPECT_LT(compared.values.at("ssim"), 0.95);
  EXPECT_GT(compared.flip.mean, 0.1);
}

TEST(CompareImages, TheFirstIsTheReference) {
  const ImageComparison brighter = compare_images(picture(true, 1.0F), "a", picture(true, 1.5F), "b", {});
  EXPECT_NEAR(brighter.values.at("bias"), 0.5, 1e-6);
  EXPECT_GT(brighter.flip.mean, 0.0);
}

TEST(CompareImages, OptionsReachFlip) {
  const ImageFile a = picture(true, 1.0F), b = picture(true, 1.5F);
  const ExposureRange range{-1.0F, 1.0F, 3};
  const ImageComparison given = compare_images(a, "a", b, "b", {30.0F, range});
  const std::vector<float> map = hdr_flip_map(24, 16, a.image.pixels, b.image.pixels, range, ToneMapper::aces, 30.0F);
  EXPECT_EQ(given.flip.mean, flip_statistics(map).mean);
  const ImageFile c = picture(false, 1.0F), d = picture(false, 0.5F);
  EXPECT_EQ(compare_images(c, "c", d, "d", {30.0F, {}}).flip.mean,
            flip_statistics(flip_map(24, 16, c.image.pixels, d.image.pixels, 30.0F)).mean);
}

TEST(CompareImages, WhatCannotBeComparedIsNamed) {
  ImageFile other = picture(true, 1.0F);
  other.image.width = 16, other.image.height = 24;
  EXPECT_THAT(refusal(picture(true, 1.0F), other),
              HasSubstr("test.exr: is 16 x 24 pixels, but the reference ref.exr is 24 x 16"));
  EXPECT_THAT(refusal(picture(true, 1.0F), picture(false, 1.0F)), HasSubstr("sRGB levels"));
  ImageFile broken = picture(true, 1.0F);
  broken.image.pixels[24 * 2 + 5].b = std::numeric_limits<float>::infinity();
  EXPECT_THAT(refusal(picture(true, 1.0F), broken), HasSubstr("test.exr: pixel (5, 2) is not finite"));
  EXPECT_THAT(refusal(broken, picture(true, 1.0F)), HasSubstr("ref.exr: pixel (5, 2)"));
  EXPECT_THAT(refusal(picture(false, 1.0F), picture(false, 1.0F), {67.0F, ExposureRange{0.0F, 1.0F, 2}}),
              HasSubstr("--exposures"));
}

}  // namespace
}  // namespace gibench
