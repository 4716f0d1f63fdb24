/// The metrics of what is seen, against a reference in replicates.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "common/image/exposure.h"
#include "common/metrics/error_value.h"
#include "common/metrics/intervals.h"
#include "common/metrics/replicas.h"

namespace gibench {

/// A picture and what it is compared with: the mean of the reference, and the means without each group of replicates, from
/// which the interval comes. `noisy` is compared with the mean for the noise floor.
struct Pictures {
  std::vector<Rgb> test, mean, noisy;
  std::vector<std::vector<Rgb>> without;
};

/// What the metrics of pictures are taken of.
struct PictureComparison {
  int width, height;
  Exposure exposure;
  Pictures linear;
  Pictures shown;  ///< display values at the exposure
};

/// psnr, ssim and flip at the exposure's value, hdr_flip (ACES) over its range, all against the mean of the reference at
/// default_pixels_per_degree; flip and hdr_flip are the means of their maps. Intervals by the delete-a-group jackknife over
/// min(R, 8) groups of replicates. ssim is empty for pictures under 11 pixels wide or high. For psnr and ssim, which are
/// larger where the error is smaller, `noise_floor` is a ceiling: what the reference's own noise would give.
std::optional<ErrorValue> psnr_error(const PictureComparison& comparison);
std::optional<ErrorValue> ssim_error(const PictureComparison& comparison);
std::optional<ErrorValue> flip_error(const PictureComparison& comparison);
std::optional<ErrorValue> hdr_flip_error(const PictureComparison& comparison);

PictureComparison compare_pictures(int width, int height, std::span<const Rgb> pixels, const Replicas& reference,
                                   const Exposure& exposure);

/// A metric taken against the mean of the reference, whose noise makes it larger, in quadrature: the low end of its
/// interval goes down by as much, to √(low² − floor²), as far down as 0 where error and noise are alike.
ErrorValue error_against_mean(double value, const Interval& interval, double floor);

}  // namespace gibench
