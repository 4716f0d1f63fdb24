#include "common/metrics/display_metrics.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/metrics/separable_filter.h"

namespace gibench {

namespace {

constexpr int window_radius = ssim_window / 2;
constexpr float c1 = 0.01F * 0.01F, c2 = 0.03F * 0.03F;

Plane luma(int width, int height, std::span<const Rgb> display) {
  Plane plane(width, height);
  std::transform(display.begin(), display.end(), plane.values.begin(), [](const Rgb& pixel) { return luminance(pixel); });
  return plane;
}

Plane product(const Plane& a, const Plane& b) {
  Plane plane(a.width, a.height);
  std::transform(a.values.begin(), a.values.end(), b.values.begin(), plane.values.begin(), std::multiplies<>());
  return plane;
}

Plane windowed_mean(const Plane& plane) {
  static const std::vector<float> filter = gaussian_filter(1.5, window_radius);
  return filter_columns(filter_rows(plane, filter), filter);
}

}  // namespace

double psnr(std::span<const Rgb> display, std::span<const Rgb> display_reference) {
  GIBENCH_CHECK(display.size() == display_reference.size() && !display.empty(), "one reference pixel for each pixel");
  RgbDouble sum;
  for (std::size_t i = 0; i < display.size(); ++i) {
    const RgbDouble difference = RgbDouble(display[i]) - RgbDouble(display_reference[i]);
    sum += difference * difference;
  }
  const double mean = (sum.r + sum.g + sum.b) / (3.0 * static_cast<double>(display.size()));
  return mean > 0.0 ? std::min(most_decibels, -10.0 * std::log10(mean)) : most_decibels;
}

std::optional<double> ssim(int width, int height, std::span<const Rgb> display, std::span<const Rgb> display_reference) {
  GIBENCH_CHECK(display.size() == display_reference.size(), "one reference pixel for each pixel");
  if (std::min(width, height) < ssim_window) return std::nullopt;
  const Plane x = luma(width, height, display), y = luma(width, height, display_reference);
  const Plane mean_x = windowed_mean(x), mean_y = windowed_mean(y);
  const Plane mean_xx = windowed_mean(product(x, x)), mean_yy = windowed_mean(product(y, y)),
              mean_xy = windowed_mean(product(x, y));
  double sum = 0.0;
  for (int row = window_radius; row < height - window_radius; ++row)
    for (int column = window_radius; column < width - window_radius; ++column) {
      const float mx = mean_x.row(row)[column], my = mean_y.row(row)[column];
      const float variance_x = mean_xx.row(row)[column] - mx * mx, variance_y = mean_yy.row(row)[column] - my * my;
      const float covariance = mean_xy.row(row)[column] - mx * my;
      const float similarity =
          (2.0F * mx * my + c1) * (2.0F * covariance + c2) / ((mx * mx + my * my + c1) * (variance_x + variance_y + c2));
      sum += double{similarity};
    }
  return sum / (static_cast<double>(width - 2 * window_radius) * static_cast<double>(height - 2 * window_radius));
}

}  // namespace gibench
