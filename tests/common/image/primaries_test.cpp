#include "common/image/primaries.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace gibench {
namespace {

void expect_columns(const Chromaticities& from, const Rgb& red, const Rgb& green, const Rgb& blue) {
  const auto convert = ColourConversion::to_rec709(from);
  ASSERT_TRUE(convert);
  const std::pair<Rgb, Rgb> pairs[] = {{Rgb(1, 0, 0), red}, {Rgb(0, 1, 0), green}, {Rgb(0, 0, 1), blue}, {Rgb(1), Rgb(1)}};
  for (const auto& [colour, converted] : pairs)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR((*convert)(colour)[c], converted[c], 2e-5F) << colour.r << colour.g << colour.b << c;
}

TEST(Primaries, AcesAsItsCommitteePublishesIt) {
  // Academy S-2014-004: AP0 to Rec. 709, D60 to D65 by Bradford.
  expect_columns({0.7347F, 0.2653F, 0.0F, 1.0F, 0.0001F, -0.077F, 0.32168F, 0.33767F}, {2.5216862F, -0.2764799F, -0.0153781F},
                 {-1.1341310F, 1.3727191F, -0.1529753F}, {-0.3875552F, -0.0962392F, 1.1683534F});
}

TEST(Primaries, Rec2020AsTheItuPublishesIt) {
  // ITU-R BT.2087-0: one white, no adaptation.
  expect_columns({0.708F, 0.292F, 0.17F, 0.797F, 0.131F, 0.046F, 0.3127F, 0.3290F}, {1.660491F, -0.124550F, -0.018151F},
                 {-0.587641F, 1.132900F, -0.100579F}, {-0.072850F, -0.008349F, 1.118730F});
}

TEST(Primaries, TristimulusValuesAreAsColour) {
  // Red, green and blue are X, Y and Z themselves, the white is that of equal energy.
  expect_columns({1.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F, 1.0F / 3.0F, 1.0F / 3.0F}, {3.146658F, -0.995522F, 0.063595F},
                 {-1.666464F, 1.955757F, -0.214563F}, {-0.480194F, 0.039765F, 1.150968F});
}

TEST(Primaries, ThoseOfRec709ChangeNothing) {
  expect_columns(rec709_chromaticities, Rgb(1, 0, 0), Rgb(0, 1, 0), Rgb(0, 0, 1));
  EXPECT_TRUE(are_rec709(rec709_chromaticities));
  EXPECT_TRUE(are_rec709({0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.31271F, 0.32902F})) << "more digits of the same white";
  EXPECT_FALSE(are_rec709({0.64F, 0.33F, 0.29F, 0.60F, 0.15F, 0.06F, 0.3333F, 0.3333F})) << "Radiance's own";
}

TEST(Primaries, WhatSpansNoColoursHasNoConversion) {
  EXPECT_FALSE(ColourConversion::to_rec709({}));
  EXPECT_FALSE(ColourConversion::to_rec709({0.64F, 0.33F, 0.30F, 0.60F, 0.47F, 0.465F, 0.3127F, 0.3290F})) << "one line";
  EXPECT_FALSE(ColourConversion::to_rec709({0.64F, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.0F})) << "no white";
  EXPECT_FALSE(ColourConversion::to_rec709({NAN, 0.33F, 0.30F, 0.60F, 0.15F, 0.06F, 0.3127F, 0.3290F}));
}

}  // namespace
}  // namespace gibench
