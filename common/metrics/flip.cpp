#include "common/metrics/flip.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "common/core/error.h"
#include "common/core/parallel.h"
#include "common/core/vec.h"
#include "common/image/srgb.h"
#include "common/metrics/flip_colour.h"
#include "common/metrics/flip_filters.h"

namespace gibench {

namespace {

constexpr std::size_t pixels_per_chunk = 16384;

// The constants of the paper's section 4.3.
constexpr float colour_exponent = 0.7F;      // q_c
constexpr float knee_of_differences = 0.4F;  // p_c, share of the largest difference
constexpr float knee_of_errors = 0.95F;      // p_t, share of the error range that differences under the knee get

struct OpponentPlanes {
  Plane luminance, red_green, blue_yellow;
};

template <class Body>
void for_each_pixel(std::size_t count, const Body& body) {
  parallel_chunks(0, count, pixels_per_chunk, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) body(i);
  });
}

OpponentPlanes opponent_planes(int width, int height, std::span<const Rgb> pixels) {
  OpponentPlanes planes{Plane(width, height), Plane(width, height), Plane(width, height)};
  for_each_pixel(pixels.size(), [&](std::size_t i) {
    const ColourTriple c = ycxcz(clamp_unit(pixels[i]));
    planes.luminance.values[i] = c.x;
    planes.red_green.values[i] = c.y;
    planes.blue_yellow.values[i] = c.z;
  });
  return planes;
}

Plane filtered(const Plane& plane, std::span<const float> along_rows, std::span<const float> along_columns) {
  return filter_columns(filter_rows(plane, along_rows), along_columns);
}

/// The one expensive loop over pixels: with these pointers the compiler may work on many pixels at once.
void perceived_colours(const float* __restrict luminance, const float* __restrict red_green, const float* __restrict narrow,
                       const float* __restrict wide, float* __restrict lightness, float* __restrict a, float* __restrict b,
                       int count) {
  for (int i = 0; i < count; ++i) {
    const ColourTriple lab = hunt_lab(clamp_unit(rgb_of_ycxcz({luminance[i], red_green[i], narrow[i] + wide[i]})));
    lightness[i] = lab.x;
    a[i] = lab.y;
    b[i] = lab.z;
  }
}

/// Filters the opponent channels by the contrast sensitivity functions and turns them into Hunt-adjusted L*a*b*.
void add_colours(const OpponentPlanes& planes, const ContrastFilters& filters, FlipFeatures& features) {
  const Plane luminance = filtered(planes.luminance, filters.luminance, filters.luminance);
  const Plane red_green = filtered(planes.red_green, filters.red_green, filters.red_green);
  const Plane narrow = filtered(planes.blue_yellow, filters.blue_yellow_narrow, filters.blue_yellow_narrow);
  const Plane wide = filtered(planes.blue_yellow, filters.blue_yellow_wide, filters.blue_yellow_wide);
  for (Plane* plane : {&features.lightness, &features.a, &features.b}) *plane = Plane(luminance.width, luminance.height);
  parallel_chunks(0, luminance.values.size(), pixels_per_chunk, [&](const ChunkRange& range) {
    const auto at = [&](const Plane& plane) { return plane.values.data() + range.begin; };
    const auto to = [&](Plane& plane) { return plane.values.data() + range.begin; };
    perceived_colours(at(luminance), at(red_green), at(narrow), at(wide), to(features.lightness), to(features.a), to(features.b),
                      static_cast<int>(range.end - range.begin));
  });
}

Plane magnitude(const Plane& a, const Plane& b) {
  Plane plane(a.width, a.height);
  for_each_pixel(plane.values.size(),
                 [&](std::size_t i) { plane.values[i] = std::sqrt(a.values[i] * a.values[i] + b.values[i] * b.values[i]); });
  return plane;
}

/// Edges and points of the luminance, in [0, 1] before the filters.
void add_features(const Plane& luminance, const FeatureFilters& filters, FlipFeatures& features) {
  Plane unit(luminance.width, luminance.height);
  for_each_pixel(unit.values.size(), [&](std::size_t i) { unit.values[i] = (luminance.values[i] + 16.0F) / 116.0F; });
  const Plane smooth = filter_rows(unit, filters.gaussian);
  features.edges = magnitude(filtered(unit, filters.edge, filters.gaussian), filter_columns(smooth, filters.edge));
  features.points = magnitude(filtered(unit, filters.point, filters.gaussian), filter_columns(smooth, filters.point));
}

/// The largest colour difference of the paper's redistribution: between saturated green and blue.
float largest_colour_difference() {
  return std::pow(hyab(hunt_lab({0.0F, 1.0F, 0.0F}), hunt_lab({0.0F, 0.0F, 1.0F})), colour_exponent);
}

/// Differences under the knee are spread over most of [0, 1]: the larger ones are all plainly visible.
float redistributed(float difference, float largest) {
  const float knee = knee_of_differences * largest;
  if (difference < knee) return difference * knee_of_errors / knee;
  return knee_of_errors + (difference - knee) / (largest - knee) * (1.0F - knee_of_errors);
}

}  // namespace

FlipFeatures flip_features(int width, int height, std::span<const Rgb> pixels, float pixels_per_degree) {
  GIBENCH_CHECK(width > 0 && height > 0 && pixels.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height),
                "one value for each pixel");
  GIBENCH_CHECK(pixels_per_degree > 0.0F, "the display is seen from a distance");
  FlipFeatures features;
  const OpponentPlanes planes = opponent_planes(width, height, pixels);
  add_colours(planes, contrast_filters(pixels_per_degree), features);
  add_features(planes.luminance, feature_filters(pixels_per_degree), features);
  return features;
}

std::vector<float> flip_differences(const FlipFeatures& reference, const FlipFeatures& test) {
  const std::size_t count = reference.lightness.values.size();
  GIBENCH_CHECK(test.lightness.values.size() == count && test.lightness.width == reference.lightness.width,
                "both pictures have one size");
  static const float largest = largest_colour_difference();
  const auto colour_at = [](const FlipFeatures& f, std::size_t i) {
    return ColourTriple{f.lightness.values[i], f.a.values[i], f.b.values[i]};
  };
  std::vector<float> errors(count);
  for_each_pixel(count, [&](std::size_t i) {
    const float distance = hyab(colour_at(reference, i), colour_at(test, i));
    const float colour = redistributed(std::pow(distance, colour_exponent), largest);
    const float edge = std::abs(reference.edges.values[i] - test.edges.values[i]);
    const float point = std::abs(reference.points.values[i] - test.points.values[i]);
    const float feature = std::sqrt(std::max(edge, point) / std::sqrt(2.0F));  // the exponent q_f is 1/2
    errors[i] = std::pow(colour, 1.0F - feature);
  });
  return errors;
}

std::vector<float> flip_map(int width, int height, std::span<const Rgb> reference, std::span<const Rgb> test,
                            float pixels_per_degree) {
  return flip_differences(flip_features(width, height, reference, pixels_per_degree),
                          flip_features(width, height, test, pixels_per_degree));
}

FlipStatistics flip_statistics(std::span<const float> errors) {
  GIBENCH_CHECK(!errors.empty(), "statistics need values");
  std::vector<float> sorted(errors.begin(), errors.end());
  std::sort(sorted.begin(), sorted.end());
  const double sum = std::accumulate(sorted.begin(), sorted.end(), 0.0);
  const auto weighted_quantile = [&](double share) {
    double running = 0.0;
    for (const float error : sorted)
      if ((running += error) > share * sum) return double{error};
    return double{sorted.back()};
  };
  return {sum / static_cast<double>(sorted.size()),
          weighted_quantile(0.5),
          weighted_quantile(0.25),
          weighted_quantile(0.75),
          double{sorted.front()},
          double{sorted.back()}};
}

}  // namespace gibench
