#include "common/metrics/automatic_exposure.h"

#include <cmath>

#include "common/metrics/hdr_flip.h"

namespace gibench {

Exposure automatic_exposure(std::span<const Rgb> pixels) {
  double sum_of_logarithms = 0.0;
  std::size_t lit = 0;
  for (const Rgb& pixel : pixels)
    if (const double y = luminance(RgbDouble(pixel)); y > 0.0 && std::isfinite(y)) {
      sum_of_logarithms += std::log2(y);
      ++lit;
    }
  if (lit == 0) return {0.0F, 0.0F, 1.0F};
  const double middle = std::log2(0.18) - sum_of_logarithms / static_cast<double>(lit);
  const ExposureRange range = automatic_exposures(pixels);
  return {static_cast<float>(middle), range.start, range.stop};
}

}  // namespace gibench
