/// Convolution of picture planes with separable filters, the border pixels carried on outwards. The same bits for any
/// number of threads.
#pragma once

#include <span>
#include <vector>

namespace gibench {

/// One channel of a picture, row-major from the top.
struct Plane {
  int width = 0, height = 0;
  std::vector<float> values;

  Plane() = default;
  Plane(int plane_width, int plane_height)
      : width(plane_width),
        height(plane_height),
        values(static_cast<std::size_t>(plane_width) * static_cast<std::size_t>(plane_height)) {}
  float* row(int y) { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
  const float* row(int y) const { return values.data() + static_cast<std::ptrdiff_t>(y) * width; }
};

/// out(x) = Σ_t filter[t + radius] in(x + t), |t| ≤ radius; the filter has 2 radius + 1 weights.
Plane filter_rows(const Plane& plane, std::span<const float> filter);
/// The same along columns.
Plane filter_columns(const Plane& plane, std::span<const float> filter);

/// exp(−x²/(2 σ²)) for |x| ≤ radius, scaled to sum 1.
std::vector<float> gaussian_filter(double sigma, int radius);

}  // namespace gibench
