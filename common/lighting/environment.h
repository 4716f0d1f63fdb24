/// The light around a scene: radiance by direction, and directions drawn from it.
#pragma once

#include <memory>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

/// One environment light. A picture is constant in each of its pixels, so that its sampling density is exact.
class Environment {
 public:
  explicit Environment(const EnvironmentLight& light);

  /// W/(m² sr), from a unit direction.
  Rgb radiance(const Vec3& direction) const;
  /// ∫ radiance dω over the sphere, largest channel, W/m²; what the light is chosen by.
  double integral() const { return integral_; }

  /// Picture: a direction with density ∝ pixel radiance. Constant: cosine-distributed about `normal`.
  Vec3 sample(Vec2 u, const Vec3& normal) const;
  /// Density of sample(), 1/sr.
  float pdf(const Vec3& direction, const Vec3& normal) const;

 private:
  std::size_t pixel_of(const Vec3& direction) const;
  void tabulate();

  Rgb factor_;
  std::shared_ptr<const EnvironmentImage> image_;
  float rotation_ = 0.0F;  ///< radians about +y
  double integral_ = 0.0;
  std::vector<float> row_cdf_;     ///< height + 1
  std::vector<float> column_cdf_;  ///< height × (width + 1)
  std::vector<float> density_;     ///< per pixel, 1/sr
};

}  // namespace gibench
