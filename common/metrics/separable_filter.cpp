#include "common/metrics/separable_filter.h"

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/core/parallel.h"

namespace gibench {

namespace {

/// Some 16,000 pixels: enough work for a thread to be worth waking.
std::size_t rows_per_chunk(const Plane& plane) { return std::max<std::size_t>(1, 16384 / static_cast<std::size_t>(plane.width)); }

/// sums += weight × values: the one inner loop of every filter, which the compiler makes vectors of.
void add_scaled(float* __restrict sums, const float* __restrict values, float weight, int count) {
  for (int x = 0; x < count; ++x) sums[x] += weight * values[x];
}

int radius_of(std::span<const float> filter) {
  GIBENCH_CHECK(filter.size() % 2 == 1, "a filter has a middle");
  return static_cast<int>(filter.size() / 2);
}

}  // namespace

Plane filter_rows(const Plane& plane, std::span<const float> filter) {
  const int radius = radius_of(filter);
  Plane out(plane.width, plane.height);
  parallel_chunks(0, static_cast<std::size_t>(plane.height), rows_per_chunk(plane), [&](const ChunkRange& range) {
    std::vector<float> padded(static_cast<std::size_t>(plane.width + 2 * radius));
    for (int y = static_cast<int>(range.begin); y < static_cast<int>(range.end); ++y) {
      const float* const in = plane.row(y);
      std::fill_n(padded.begin(), radius, in[0]);
      std::copy_n(in, plane.width, padded.begin() + radius);
      std::fill_n(padded.begin() + radius + plane.width, radius, in[plane.width - 1]);
      for (std::size_t t = 0; t < filter.size(); ++t) add_scaled(out.row(y), padded.data() + t, filter[t], plane.width);
    }
  });
  return out;
}

Plane filter_columns(const Plane& plane, std::span<const float> filter) {
  const int radius = radius_of(filter);
  Plane out(plane.width, plane.height);
  parallel_chunks(0, static_cast<std::size_t>(plane.height), rows_per_chunk(plane), [&](const ChunkRange& range) {
    for (int y = static_cast<int>(range.begin); y < static_cast<int>(range.end); ++y)
      for (int t = -radius; t <= radius; ++t) {
        const float* const in = plane.row(std::clamp(y + t, 0, plane.height - 1));
        add_scaled(out.row(y), in, filter[static_cast<std::size_t>(t + radius)], plane.width);
      }
  });
  return out;
}

std::vector<float> gaussian_filter(double sigma, int radius) {
  std::vector<double> weights;
  double sum = 0.0;
  for (int x = -radius; x <= radius; ++x) {
    weights.push_back(std::exp(-0.5 * x * x / (sigma * sigma)));
    sum += weights.back();
  }
  std::vector<float> filter;
  for (const double weight : weights) filter.push_back(static_cast<float>(weight / sum));
  return filter;
}

}  // namespace gibench
