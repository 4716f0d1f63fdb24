#include "common/metrics/metric_terms.h"

namespace gibench::metric_terms {

double mean_of(std::span<const Rgb> values) {
  RgbDouble sum;
  for (const Rgb& value : values) sum += RgbDouble(value);
  return (sum.r + sum.g + sum.b) / (3.0 * static_cast<double>(values.size()));
}

void add_slope_of_mean(MetricEstimate& estimate, std::span<const Rgb> reference_mean, double mean, double by_mean) {
  const Rgb shift(static_cast<float>(by_mean));
  for (std::size_t i = 0; i < reference_mean.size(); ++i) {
    estimate.slope[i] += shift;
    estimate.parts[i] += by_mean * (mean_of(reference_mean.subspan(i, 1)) - mean);
  }
}

}  // namespace gibench::metric_terms
