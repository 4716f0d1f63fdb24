#include "bench/app/metric_names.h"

namespace gibench {

std::span<const MetricName> metric_names() {
  static constexpr MetricName names[] = {
      {"rmse", "root of the mean of (x-A)(x-B): the reference's noise does not count"},
      {"relative_rmse", "rmse over the mean of r"},
      {"bias", "mean of x-r over the mean of r"},
      {"rel_mse(0.01)", "mean (x-r)^2/(r^2+0.01)"},
      {"rel_mse_trim(0.1%)", "rel_mse without the largest 0.1% of the values"},
      {"mape(0.01)", "mean |x-r|/(|r|+0.01)"},
      {"smape(0.02)", "mean 2|x-r|/(|x|+|r|+0.02)"},
      {"max", "largest |x-r|"},
      {"psnr", "peak signal-to-noise ratio of the shown picture, dB; larger is better"},
      {"ssim", "structural similarity of the shown picture, 1 for equal; larger is better"},
      {"flip", "LDR-FLIP at the scene's stored exposure, mean over pixels, [0, 1]"},
      {"hdr_flip", "HDR-FLIP over the scene's stored exposure range, mean over pixels, [0, 1]"},
  };
  return names;
}

}  // namespace gibench
