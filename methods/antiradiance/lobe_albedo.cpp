#include "methods/antiradiance/lobe_albedo.h"

#include <algorithm>
#include <cmath>

namespace gibench::antiradiance {

namespace {

constexpr int directions = 1024;
constexpr float least_cosine = 1e-3F;  // of the first entry: at none at all there is nothing to sample

}  // namespace

LobeAlbedo::LobeAlbedo(const SurfaceBsdf& bsdf) {
  for (std::size_t k = 0; k <= intervals; ++k) {
    const float cosine = std::max(least_cosine, static_cast<float>(k) / static_cast<float>(intervals));
    const Vec3 out(std::sqrt(std::max(0.0F, 1.0F - cosine * cosine)), 0.0F, cosine);
    RgbDouble sum;
    for (int i = 0; i < directions; ++i) {
      const float u = (static_cast<float>(i) + 0.5F) / static_cast<float>(directions), v = 0.61803398875F * static_cast<float>(i);
      sum += RgbDouble(bsdf.sample(out, u, {u, v - std::floor(v)}).weight);
    }
    values_[k] = Rgb(sum / static_cast<double>(directions));
  }
}

Rgb LobeAlbedo::at(float cosine) const {
  const float place = std::clamp(cosine, 0.0F, 1.0F) * static_cast<float>(intervals);
  const auto below = std::min(intervals - 1, static_cast<std::size_t>(place));
  const float share = place - static_cast<float>(below);
  return values_[below] * (1.0F - share) + values_[below + 1] * share;
}

}  // namespace gibench::antiradiance
