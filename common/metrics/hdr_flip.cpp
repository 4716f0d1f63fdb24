#include "common/metrics/hdr_flip.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/core/error.h"
#include "common/core/parallel.h"
#include "common/image/srgb.h"

namespace gibench {

namespace {

/// (k0 x² + k1 x + k2) / (k3 x² + k4 x + k5).
using Rational = std::array<double, 6>;

/// Narkowicz' fit of ACES without its built-in exposure of 0.6; Reinhard et al. (2002); Hable (2010) scaled to white.
Rational curve_of(ToneMapper tone_mapper) {
  switch (tone_mapper) {
    case ToneMapper::reinhard: return {0.0, 1.0, 0.0, 0.0, 1.0, 1.0};
    case ToneMapper::hable: return {0.231683, 0.013791, 0.0, 0.18, 0.3, 0.018};
    case ToneMapper::aces: break;
  }
  return {0.6 * 0.6 * 2.51, 0.6 * 0.03, 0.0, 0.6 * 0.6 * 2.43, 0.6 * 0.59, 0.14};
}

/// The value that the curve takes to `level`: the larger root of a quadratic, or the root of a line.
double inverse_of(const Rational& k, double level) {
  const double a = k[0] - level * k[3], b = k[1] - level * k[4], c = k[2] - level * k[5];
  if (a == 0.0) return -c / b;
  const double root = std::sqrt(b * b - 4.0 * a * c);
  return std::max((-b + root) / (2.0 * a), (-b - root) / (2.0 * a));
}

double median_of_sorted(std::span<const double> sorted) {
  const std::size_t middle = sorted.size() / 2;
  return sorted.size() % 2 == 1 ? sorted[middle] : 0.5 * (sorted[middle - 1] + sorted[middle]);
}

}  // namespace

std::vector<float> ExposureRange::exposures() const {
  GIBENCH_CHECK(count >= 1, "a range has an exposure");
  std::vector<float> steps;
  for (int i = 0; i < count; ++i)
    steps.push_back(count == 1 ? start : start + (stop - start) * static_cast<float>(i) / static_cast<float>(count - 1));
  return steps;
}

ExposureRange exposure_range(float start, float stop) {
  return {start, stop, std::max(2, static_cast<int>(std::ceil(stop - start)))};
}

ExposureRange automatic_exposures(std::span<const Rgb> reference, ToneMapper tone_mapper) {
  std::vector<double> luminances;  // the sum of three floats may be more than a float
  for (const Rgb& pixel : reference) luminances.push_back(std::max(0.0, luminance(RgbDouble(pixel))));
  std::sort(luminances.begin(), luminances.end());
  if (luminances.empty() || !(luminances.back() > 0.0)) return {0.0F, 0.0F, 2};
  double median = median_of_sorted(luminances);
  if (!(median > 0.0)) {
    const auto first_lit = std::upper_bound(luminances.begin(), luminances.end(), 0.0);
    median = median_of_sorted(std::span(first_lit, luminances.end()));
  }
  const double bright = inverse_of(curve_of(tone_mapper), 0.85);
  return exposure_range(static_cast<float>(std::log2(bright / luminances.back())),
                        static_cast<float>(std::log2(bright / median)));
}

std::vector<Rgb> tone_mapped(std::span<const Rgb> pixels, float exposure, ToneMapper tone_mapper) {
  std::array<float, 6> k;
  std::ranges::transform(curve_of(tone_mapper), k.begin(), [](double coefficient) { return static_cast<float>(coefficient); });
  const double scale = std::exp2(static_cast<double>(exposure));  // of the largest floats it is less than a float holds
  constexpr double white = 1e8;  // where every curve has long reached its end, and squares stay finite
  const auto map = [&](float value) {
    const auto x = static_cast<float>(std::clamp(scale * static_cast<double>(value), 0.0, white));
    return clamp_unit((k[0] * x * x + k[1] * x + k[2]) / (k[3] * x * x + k[4] * x + k[5]));
  };
  std::vector<Rgb> mapped(pixels.size());
  parallel_chunks(0, pixels.size(), 16384, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) mapped[i] = {map(pixels[i].r), map(pixels[i].g), map(pixels[i].b)};
  });
  return mapped;
}

std::vector<float> hdr_flip_map(int width, int height, std::span<const Rgb> reference, std::span<const Rgb> test,
                                const ExposureRange& range, ToneMapper tone_mapper, float pixels_per_degree) {
  std::vector<float> largest(reference.size(), 0.0F);
  for (const float exposure : range.exposures()) {
    const std::vector<float> errors = flip_map(width, height, tone_mapped(reference, exposure, tone_mapper),
                                               tone_mapped(test, exposure, tone_mapper), pixels_per_degree);
    for (std::size_t i = 0; i < largest.size(); ++i) largest[i] = std::max(largest[i], errors[i]);
  }
  return largest;
}

}  // namespace gibench
