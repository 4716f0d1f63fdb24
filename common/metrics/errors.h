/// Errors of a method's values against a reference that is itself uncertain, with intervals. Names carry their
/// constants. The squared error is mean (x−A)(x−B) over the two reference halves, so that the reference's noise
/// does not count against the method; the noise floor is ¼ mean (A−B)².
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>

#include "common/core/rgb.h"
#include "common/metrics/replicas.h"
#include "common/scene/scene.h"

namespace gibench {

struct ErrorValue {
  double value = 0.0;
  double low = 0.0, high = 0.0;       ///< 95% interval over the reference replicates (jackknife, Student t)
  std::optional<double> noise_floor;  ///< in the metric's unit: what the reference's own noise would give
  bool below_noise_floor = false;     ///< then `value` says no more than that it is small
};
using ErrorTable = std::map<std::string, ErrorValue>;

/// rmse, relative_rmse (rmse over the mean of r), bias, rel_mse(0.01), rel_mse_trim(0.1%), mape(0.01), smape(0.02), max.
/// Channels are averaged. Needs two replicates at least.
ErrorTable value_errors(std::span<const Rgb> values, const Replicas& reference);

/// value_errors of the pixels, and psnr, ssim, flip at the exposure's value and hdr_flip over its range.
ErrorTable image_errors(int width, int height, std::span<const Rgb> pixels, const Replicas& reference, const Exposure& exposure);

/// An exposure for a scene that stores none: from the luminance of the reference image.
Exposure automatic_exposure(std::span<const Rgb> pixels);

}  // namespace gibench
