/// Every image metric of two pictures, the first taken as exact.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "common/image/image_file.h"
#include "common/metrics/flip.h"
#include "common/metrics/hdr_flip.h"

namespace gibench {

/// The viewing conditions that FLIP depends on.
struct ComparisonOptions {
  float pixels_per_degree = default_pixels_per_degree;
  std::optional<ExposureRange> exposures;  ///< of HDR-FLIP; empty: automatic_exposures of the reference
};

/// The metrics of one pair of pictures.
struct ImageComparison {
  std::map<std::string, double> values;  ///< metric → value, those of metric_table.h but for FLIP
  std::string flip_name;                 ///< "flip" for pictures of limited range, "hdr_flip" for EXR and HDR
  FlipStatistics flip;
};

/// psnr and ssim are of what a display shows: as stored for pictures of limited range, at automatic_exposure of the
/// reference for others. ssim is absent for pictures under 11 pixels wide or high. InputError where the two pictures differ in
/// size or kind, hold a value that is not finite, or exposures are given for pictures of limited range. The names are for it.
ImageComparison compare_images(const ImageFile& reference, const std::string& reference_name, const ImageFile& test,
                               const std::string& test_name, const ComparisonOptions& options);

}  // namespace gibench
