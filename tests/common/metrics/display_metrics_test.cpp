#include "common/metrics/display_metrics.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/core/random.h"
#include "common/metrics/separable_filter.h"

namespace gibench {
namespace {

using Pixels = std::vector<Rgb>;

Pixels noise(int count, std::uint64_t seed) {
  Pixels pixels;
  RandomStream random(seed, 1, 0);
  for (int i = 0; i < count; ++i) pixels.push_back({random.next_float(), random.next_float(), random.next_float()});
  return pixels;
}

/// SSIM window by window in double, as its paper writes it.
double direct_ssim(int width, int height, const Pixels& a, const Pixels& b) {
  double weights[11][11], weight_sum = 0.0;
  for (int v = 0; v < 11; ++v)
    for (int u = 0; u < 11; ++u)
      weight_sum += weights[v][u] = std::exp(-((u - 5) * (u - 5) + (v - 5) * (v - 5)) / (2.0 * 1.5 * 1.5));
  double sum = 0.0;
  int windows = 0;
  for (int y = 0; y + 11 <= height; ++y)
    for (int x = 0; x + 11 <= width; ++x, ++windows) {
      double ma = 0.0, mb = 0.0, aa = 0.0, bb = 0.0, ab = 0.0;
      for (int v = 0; v < 11; ++v)
        for (int u = 0; u < 11; ++u) {
          const auto place = static_cast<std::size_t>((y + v) * width + x + u);
          const double w = weights[v][u] / weight_sum, p = double{luminance(a[place])}, q = double{luminance(b[place])};
          ma += w * p, mb += w * q, aa += w * p * p, bb += w * q * q, ab += w * p * q;
        }
      const double c1 = 0.0001, c2 = 0.0009;
      sum += (2 * ma * mb + c1) * (2 * (ab - ma * mb) + c2) / ((ma * ma + mb * mb + c1) * (aa - ma * ma + bb - mb * mb + c2));
    }
  return sum / windows;
}

TEST(DisplayMetrics, SsimIsThatOfItsPaper) {
  const Pixels a = noise(30 * 17, 1), b = noise(30 * 17, 2);
  Pixels near = a;
  for (std::size_t i = 0; i < near.size(); ++i) near[i] += 0.1F * (b[i] - a[i]);
  EXPECT_NEAR(ssim(30, 17, a, b).value(), direct_ssim(30, 17, a, b), 1e-5);
  EXPECT_NEAR(ssim(30, 17, near, a).value(), direct_ssim(30, 17, near, a), 1e-5);
}

TEST(DisplayMetrics, SsimOfEqualAndOfConstantPictures) {
  const Pixels a = noise(20 * 20, 1);
  EXPECT_DOUBLE_EQ(ssim(20, 20, a, a).value(), 1.0);
  const Pixels dark(400, Rgb(0.2F)), light(400, Rgb(0.6F));  // the luminance term alone
  EXPECT_NEAR(ssim(20, 20, dark, light).value(), (2 * 0.2 * 0.6 + 1e-4) / (0.04 + 0.36 + 1e-4), 1e-4);
  EXPECT_FALSE(ssim(10, 40, a, a));
  EXPECT_FALSE(ssim(40, 10, a, a));
}

TEST(DisplayMetrics, PsnrByHand) {
  const Pixels a(50, Rgb(0.5F)), b(50, Rgb(0.6F));
  EXPECT_NEAR(psnr(a, b), 20.0, 1e-5);
  EXPECT_EQ(psnr(a, a), most_decibels);
}

TEST(SeparableFilter, BordersAreCarriedOn) {
  Plane plane(4, 3);
  for (int i = 0; i < 12; ++i) plane.values[static_cast<std::size_t>(i)] = static_cast<float>(i * i);
  const std::vector<float> filter{1.0F, 10.0F, 100.0F, 1000.0F, 10000.0F};
  const Plane rows = filter_rows(plane, filter), columns = filter_columns(plane, filter);
  for (int y = 0; y < 3; ++y)
    for (int x = 0; x < 4; ++x) {
      float along_row = 0.0F, along_column = 0.0F;
      for (int t = -2; t <= 2; ++t) {
        const float weight = filter[static_cast<std::size_t>(t + 2)];
        along_row += weight * plane.row(y)[std::min(std::max(x + t, 0), 3)];
        along_column += weight * plane.row(std::min(std::max(y + t, 0), 2))[x];
      }
      EXPECT_FLOAT_EQ(rows.row(y)[x], along_row);
      EXPECT_FLOAT_EQ(columns.row(y)[x], along_column);
    }
}

}  // namespace
}  // namespace gibench
