#include "common/scene_io/pictures/picture_use.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>
#include <vector>

#include "common/core/random.h"

namespace gibench {
namespace {

PictureTexels picture_of(int width, int height, const std::function<Texel(int, int)>& texel) {
  PictureTexels picture{width, height, {}, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) picture.texels.push_back(texel(x, y));
  return picture;
}

PictureTexels noise(int width, int height) {
  RandomStream random(5, 1, 0);
  return picture_of(width, height, [&](int, int) {
    const Rgb colour(random.next_float(), random.next_float(), random.next_float());
    return Texel{colour, random.next_float()};
  });
}

/// A rectangle of the picture as two triangles.
std::vector<UvTriangle> rectangle(Vec2 low, Vec2 high) {
  const Vec2 right_low(high.x, low.y), left_high(low.x, high.y);
  return {{low, right_low, high}, {low, high, left_high}};
}

PictureMean mean_over(const PictureTexels& picture, const std::vector<UvTriangle>& triangles, PictureWrap wrap = {}) {
  return mean_over_triangles(TexelSums(picture), triangles, std::vector<double>(triangles.size(), 1.0), wrap);
}

/// The means of red and opacity over many random points of one triangle.
PictureMean by_points(const PictureTexels& picture, const UvTriangle& t, const std::function<int(int, int)>& fold) {
  RandomStream random(6, 1, 0);
  RgbDouble colour;
  double opacity = 0.0;
  constexpr int points = 400000;
  for (int i = 0; i < points; ++i) {
    float b = random.next_float(), c = random.next_float();
    if (b + c > 1.0F) b = 1.0F - b, c = 1.0F - c;
    const Vec2 uv = t[0] + b * (t[1] - t[0]) + c * (t[2] - t[0]);
    const int x = fold(static_cast<int>(std::floor(uv.x * static_cast<float>(picture.width))), picture.width);
    const int y = fold(static_cast<int>(std::floor((1.0F - uv.y) * static_cast<float>(picture.height))), picture.height);
    const Texel& texel = picture.texels[static_cast<std::size_t>(y * picture.width + x)];
    colour += static_cast<double>(texel.opacity) * RgbDouble(texel.colour);
    opacity += static_cast<double>(texel.opacity);
  }
  return {Rgb(colour / opacity), opacity / points};
}

int repeated(int i, int size) { return ((i % size) + size) % size; }
int clamped(int i, int size) { return std::min(std::max(i, 0), size - 1); }
int mirrored(int i, int size) {
  const int rest = repeated(i, 2 * size);
  return rest < size ? rest : 2 * size - 1 - rest;
}

TEST(PictureUse, OnlyTheHalfThatIsUsedCounts) {
  const PictureTexels picture = picture_of(30, 20, [](int x, int) { return Texel{Rgb(x < 15 ? 0.0F : 1.0F)}; });
  EXPECT_EQ(mean_over(picture, rectangle({0.5F, 0.0F}, {1.0F, 1.0F})).colour, Rgb(1.0F));
  EXPECT_EQ(mean_over(picture, rectangle({0.0F, 0.0F}, {0.5F, 1.0F})).colour, Rgb(0.0F));
  EXPECT_FLOAT_EQ(mean_over(picture, rectangle({0.0F, 0.0F}, {1.0F, 1.0F})).colour.r, 0.5F);
  EXPECT_FLOAT_EQ(mean_of_picture(TexelSums(picture)).colour.g, 0.5F);
}

TEST(PictureUse, VRunsUpwards) {
  const PictureTexels picture = picture_of(4, 8, [](int, int y) { return Texel{Rgb(y < 4 ? 1.0F : 0.0F)}; });
  EXPECT_EQ(mean_over(picture, rectangle({0.0F, 0.5F}, {1.0F, 1.0F})).colour, Rgb(1.0F)) << "the first row is at v = 1";
}

TEST(PictureUse, OneSixtyFourthOfAnAtlas) {
  const PictureTexels atlas = picture_of(
      64, 64, [](int x, int y) { return Texel{x >= 16 && x < 24 && y >= 40 && y < 48 ? Rgb(1.0F, 0.5F, 0.25F) : Rgb()}; });
  const PictureMean mean = mean_over(atlas, rectangle({0.25F, 0.25F}, {0.375F, 0.375F}));
  EXPECT_EQ(mean.colour, Rgb(1.0F, 0.5F, 0.25F));
  EXPECT_EQ(mean.opacity, 1.0);
}

TEST(PictureUse, TransparentTexelsHaveNoColour) {
  const PictureTexels leaf = picture_of(16, 16, [](int x, int) {
    return x % 4 == 0 ? Texel{Rgb(0.0F), 0.0F} : Texel{Rgb(0.25F, 0.5F, 1.0F), 1.0F};
  });
  const PictureMean mean = mean_over(leaf, rectangle({0.0F, 0.0F}, {1.0F, 1.0F}));
  EXPECT_EQ(mean.colour, Rgb(0.25F, 0.5F, 1.0F));
  EXPECT_NEAR(mean.opacity, 0.75, 1e-12);
  const PictureMean none = mean_of_picture(TexelSums(picture_of(2, 2, [](int, int) { return Texel{Rgb(1.0F), 0.0F}; })));
  EXPECT_EQ(none.opacity, 0.0);
  EXPECT_EQ(none.colour, Rgb());
}

TEST(PictureUse, TrianglesCountByTheirAreaOnTheSurface) {
  const PictureTexels picture = picture_of(2, 1, [](int x, int) { return Texel{Rgb(static_cast<float>(x))}; });
  // The black half of the picture is spread over three times as much surface as the white half.
  std::vector<UvTriangle> triangles = rectangle({0.0F, 0.0F}, {0.5F, 1.0F});
  for (const UvTriangle& triangle : rectangle({0.5F, 0.0F}, {1.0F, 1.0F})) triangles.push_back(triangle);
  const std::vector<double> areas{3.0, 3.0, 1.0, 1.0};
  EXPECT_FLOAT_EQ(mean_over_triangles(TexelSums(picture), triangles, areas).colour.r, 0.25F);
}

TEST(PictureUse, AnyTriangleAndAnyWrapAgreeWithPoints) {
  const PictureTexels picture = noise(13, 37);
  const UvTriangle triangles[] = {{Vec2(0.1F, 0.2F), Vec2(0.9F, 0.35F), Vec2(0.4F, 0.95F)},
                                  {Vec2(-1.7F, -0.6F), Vec2(0.3F, 2.4F), Vec2(2.2F, -1.1F)},
                                  {Vec2(3.1F, 2.0F), Vec2(3.4F, 2.9F), Vec2(3.15F, 2.95F)}};
  const std::pair<Wrap, int (*)(int, int)> wraps[] = {{Wrap::repeat, repeated}, {Wrap::clamp, clamped}, {Wrap::mirror, mirrored}};
  for (const auto& [wrap, fold] : wraps)
    for (const UvTriangle& triangle : triangles) {
      const PictureMean mean = mean_over(picture, {triangle}, {wrap, wrap}), points = by_points(picture, triangle, fold);
      // Texels have a standard deviation below 0.3: five standard errors of 400 000 points, over the mean opacity of half.
      constexpr double tolerance = 5.0 * 0.3 / 632.0 / 0.5;
      EXPECT_NEAR(mean.colour.r, points.colour.r, tolerance) << static_cast<int>(wrap);
      EXPECT_NEAR(mean.colour.b, points.colour.b, tolerance) << static_cast<int>(wrap);
      EXPECT_NEAR(mean.opacity, points.opacity, tolerance) << static_cast<int>(wrap);
      const UvTriangle turned{triangle[2], triangle[1], triangle[0]};
      EXPECT_NEAR(mean_over(picture, {turned}, {wrap, wrap}).colour.r, mean.colour.r, 1e-6F) << "either winding";
    }
}

TEST(PictureUse, PartsMakeTheWhole) {
  const PictureTexels picture = noise(31, 17);
  std::vector<UvTriangle> fan;
  std::vector<double> areas;
  const Vec2 corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}}, middle(0.37F, 0.71F);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vec2 a = corners[i], b = corners[(i + 1) % 4];
    fan.push_back({middle, a, b});
    areas.push_back(0.5 *
                    std::abs(static_cast<double>((a.x - middle.x) * (b.y - middle.y) - (b.x - middle.x) * (a.y - middle.y))));
  }
  const PictureMean parts = mean_over_triangles(TexelSums(picture), fan, areas), whole = mean_of_picture(TexelSums(picture));
  EXPECT_NEAR(parts.colour.r, whole.colour.r, 1e-6F);
  EXPECT_NEAR(parts.colour.g, whole.colour.g, 1e-6F);
  EXPECT_NEAR(parts.opacity, whole.opacity, 1e-6);
}

TEST(PictureUse, APictureLaidManyTimesHasItsMean) {
  const PictureTexels picture = noise(64, 64);
  const PictureMean whole = mean_of_picture(TexelSums(picture));
  // 4096 points (of a fixed sequence, better than independent ones) of colours with a deviation below 0.3: five of their
  // standard errors, over the mean opacity of half.
  constexpr double tolerance = 5.0 * 0.3 / 64.0 / 0.5;
  for (const float times : {256.0F, 4096.0F, 1e6F}) {
    const PictureMean mean = mean_over(picture, rectangle({0.0F, 0.0F}, {times, times}));
    EXPECT_NEAR(mean.colour.r, whole.colour.r, tolerance) << times;
    EXPECT_NEAR(mean.opacity, whole.opacity, tolerance) << times;
    EXPECT_EQ(mean_over(picture, rectangle({0.0F, 0.0F}, {times, times})).colour, mean.colour) << "the same every time";
  }
}

TEST(PictureUse, OneSetOfSumsServesAllThatWearThePicture) {
  const PictureTexels picture = noise(31, 17);
  const TexelSums sums(picture);
  const std::vector<UvTriangle> triangles{{Vec2(-0.4F, 0.2F), Vec2(1.7F, 0.4F), Vec2(0.3F, 2.2F)}};
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror, Wrap::repeat}) {
    const PictureMean mean = mean_over_triangles(sums, triangles, std::vector<double>{1.0}, {wrap, wrap});
    EXPECT_EQ(mean.colour, mean_over(picture, triangles, {wrap, wrap}).colour);
  }
  EXPECT_EQ(mean_of_picture(sums).colour, mean_of_picture(TexelSums(picture)).colour);
}

TEST(PictureUse, TrianglesThatAreAPointOrALineTakeTheirTexels) {
  const PictureTexels picture = picture_of(8, 8, [](int x, int) { return Texel{Rgb(static_cast<float>(x) / 8.0F)}; });
  const Vec2 point(0.7F, 0.3F);  // column 5
  EXPECT_FLOAT_EQ(mean_over(picture, {{point, point, point}}).colour.r, 5.0F / 8.0F);
  const UvTriangle small{point, point + Vec2(1e-5F, 0.0F), point + Vec2(0.0F, 1e-5F)};
  EXPECT_FLOAT_EQ(mean_over(picture, {small}).colour.r, 5.0F / 8.0F);
  const UvTriangle upright{Vec2(0.3F, 0.0F), Vec2(0.3F, 0.5F), Vec2(0.3F, 1.0F)};  // column 2
  EXPECT_FLOAT_EQ(mean_over(picture, {upright}).colour.r, 2.0F / 8.0F);
}

TEST(PictureUse, NumbersThatAreNoneAndHugeOnesAreSafe) {
  const PictureTexels picture = picture_of(2, 1, [](int x, int) { return Texel{Rgb(static_cast<float>(x))}; });
  const float nan = std::numeric_limits<float>::quiet_NaN(), huge = 3e38F;
  std::vector<UvTriangle> triangles = rectangle({0.5F, 0.0F}, {1.0F, 1.0F});
  triangles.push_back({Vec2(nan, 0.0F), Vec2(0.1F, 0.0F), Vec2(0.1F, 0.1F)});
  EXPECT_EQ(mean_over(picture, triangles).colour, Rgb(1.0F));
  EXPECT_FLOAT_EQ(mean_over(picture, {}).colour.r, 0.5F) << "no triangle: the whole picture";
  for (const Wrap wrap : {Wrap::repeat, Wrap::clamp, Wrap::mirror}) {
    const float red = mean_over(picture, {{Vec2(-huge, -huge), Vec2(huge, 0.0F), Vec2(0.0F, huge)}}, {wrap, wrap}).colour.r;
    EXPECT_GE(red, 0.0F);
    EXPECT_LE(red, 1.0F);
  }
}

}  // namespace
}  // namespace gibench
