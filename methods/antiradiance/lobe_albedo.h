/// The share of the light from one direction that a lobe reflects, tabulated by the cosine of incidence.
#pragma once

#include <array>

#include "common/core/rgb.h"
#include "common/reflectance/bsdf.h"

namespace gibench::antiradiance {

/// ∫ f cos over the hemisphere, [0, 1] of a lobe that gains nothing.
class LobeAlbedo {
 public:
  explicit LobeAlbedo(const SurfaceBsdf& bsdf);
  /// Linear between the tabulated cosines, [0, 1].
  Rgb at(float cosine) const;

 private:
  static constexpr std::size_t intervals = 32;
  std::array<Rgb, intervals + 1> values_;
};

}  // namespace gibench::antiradiance
