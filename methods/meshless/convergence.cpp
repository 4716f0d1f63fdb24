#include "methods/meshless/convergence.h"

#include <cmath>

#include "common/finite_elements/bounce_series.h"
#include "methods/meshless/refinement.h"

namespace gibench::meshless {

namespace {

RgbDouble magnitude_mean(const Coefficients& coefficients) {
  const Hierarchy& hierarchy = coefficients.hierarchy();
  RgbDouble sum;
  for (std::uint32_t point = 0; point < hierarchy.level_size(0); ++point) {
    const Rgb value = coefficients[point];
    sum += hierarchy.coarsest_share(point) * RgbDouble(std::fabs(value.r), std::fabs(value.g), std::fabs(value.b));
  }
  return sum;
}

}  // namespace

Convergence judge(const Coefficients& last, const Coefficients& before, const Coefficients& sum) {
  Convergence result;
  const RgbDouble last_mean = coarsest_mean(last), before_mean = coarsest_mean(before), total = magnitude_mean(sum);
  const std::uint32_t count = last.hierarchy().level_size(0);
  for (int channel = 0; channel < 3; ++channel) {
    if (!(total[channel] > 0.0)) continue;
    const double ratio = before_mean[channel] > 0.0 ? std::max(0.0, last_mean[channel] / before_mean[channel]) : 0.0;
    const double factor = ratio / share_lost(ratio);
    double departure = 0.0;
    for (std::uint32_t point = 0; point < count; ++point)
      departure += last.hierarchy().coarsest_share(point) *
                   std::fabs(static_cast<double>(last[point][channel]) - ratio * static_cast<double>(before[point][channel]));
    result.ratio[channel] = ratio;
    result.tail_factor[channel] = factor;
    result.residual = std::max(result.residual, last_mean[channel] * factor / total[channel]);
    result.departure = std::max(result.departure, departure * factor / total[channel]);
  }
  return result;
}

void add_scaled(Coefficients& sum, const Coefficients& term, const Rgb& factor) {
  for (std::uint32_t point : term.sorted_points()) sum.add(point, term[point] * factor);
}

}  // namespace gibench::meshless
