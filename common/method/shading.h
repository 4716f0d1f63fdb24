/// A question to a method at surface samples, and where its answer goes.
#pragma once

#include <span>

#include "common/core/rgb.h"
#include "common/method/quantity.h"
#include "common/ray/world.h"

namespace gibench {

/// One quantity at each sample.
struct ShadeRequest {
  Quantity quantity = Quantity::radiance;
  std::span<const SurfaceSample> samples;
  std::span<const Vec3> toward_viewer;  ///< unit directions for radiance, one for each sample; empty otherwise
};

/// Each span is empty (not asked for) or as long as the samples. Accessibility is written to `direct`, three equal
/// channels, and `indirect` is zero. Variances are those of the value itself, for each channel; asked only of methods
/// whose capabilities say that they know them.
struct ShadeAnswer {
  std::span<Rgb> direct, indirect;
  std::span<Rgb> direct_variance, indirect_variance, total_variance;

  bool empty() const {
    return direct.empty() && indirect.empty() && direct_variance.empty() && indirect_variance.empty() && total_variance.empty();
  }
};

}  // namespace gibench
