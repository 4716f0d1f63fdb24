#include "common/image/tone_mapping.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "common/image/heat_map.h"
#include "common/image/srgb.h"

namespace gibench {
namespace {

TEST(Srgb, CurvesAreInverseAndMeetTheStandard) {
  for (int i = 0; i <= 1000; ++i) {
    const float x = static_cast<float>(i) / 1000.0F;
    EXPECT_NEAR(srgb_to_linear(linear_to_srgb(x)), x, 2e-7F);
  }
  EXPECT_NEAR(srgb_to_linear(0.5F), 0.21404114F, 1e-7F);
  EXPECT_NEAR(linear_to_srgb(0.18F), 0.46135613F, 1e-6F);
  EXPECT_EQ(srgb_byte(-1.0F), 0);
  EXPECT_EQ(srgb_byte(std::numeric_limits<float>::quiet_NaN()), 0);
  EXPECT_EQ(srgb_byte(2.0F), 255);
}

TEST(ToneMapping, ExposureIsInStops) {
  const std::vector<Rgb> pixels{Rgb(0.5F, 0.1F, 4.0F)};
  const Rgb brighter = exposed(pixels, 2.0F)[0];
  EXPECT_FLOAT_EQ(brighter.r, 2.0F);
  EXPECT_FLOAT_EQ(brighter.g, 0.4F);
  const Rgb shown = display_values(pixels, 1.0F)[0];
  EXPECT_FLOAT_EQ(shown.r, 1.0F);
  EXPECT_FLOAT_EQ(shown.g, linear_to_srgb(0.2F));
  EXPECT_FLOAT_EQ(shown.b, 1.0F);
}

/// CIE lightness of a linear colour.
float lightness(const Rgb& c) {
  const float y = luminance(c);
  return y > 0.008856F ? 116.0F * std::cbrt(y) - 16.0F : 903.3F * y;
}

TEST(HeatMap, LightnessRisesEvenly) {
  // That is what makes equal steps look equal, and what every kind of colour vision sees.
  const float whole = lightness(viridis(1.0F)) - lightness(viridis(0.0F));
  EXPECT_GT(whole, 70.0F);
  for (int i = 0; i < 16; ++i) {
    const float step = lightness(viridis(static_cast<float>(i + 1) / 16.0F)) - lightness(viridis(static_cast<float>(i) / 16.0F));
    EXPECT_NEAR(step, whole / 16.0F, 0.35F * whole / 16.0F) << i;
  }
}

TEST(HeatMap, EndsAndOutsidesAreClamped) {
  EXPECT_EQ(srgb_byte(viridis(0.0F).r), 0x44);
  EXPECT_EQ(srgb_byte(viridis(1.0F).r), 0xfd);
  EXPECT_EQ(srgb_byte(viridis(0.5F).g), 0x91);
  EXPECT_EQ(viridis(-3.0F), viridis(0.0F));
  EXPECT_EQ(viridis(7.0F), viridis(1.0F));
  EXPECT_EQ(viridis(std::numeric_limits<float>::quiet_NaN()), viridis(0.0F));
  const Image map = heat_map(2, 1, std::vector<float>{1.0F, 3.0F}, 1.0F, 5.0F);
  EXPECT_EQ(map.pixels[0], viridis(0.0F));
  EXPECT_EQ(map.pixels[1], viridis(0.5F));
}

TEST(HeatMap, RelativeErrorsByHand) {
  const std::vector<Rgb> x{Rgb(2.0F, 1.0F, 0.0F)}, r{Rgb(1.0F, 1.0F, 1.0F)};
  EXPECT_NEAR(relative_error_map(x, r)[0], (1.0F / 1.01F + 0.0F + 1.0F / 1.01F) / 3.0F, 1e-6F);
}

}  // namespace
}  // namespace gibench
