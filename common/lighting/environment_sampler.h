/// Light from infinitely far away: radiance by direction, and directions in proportion to it.
#pragma once

#include <memory>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

/// One environment light. An image's radiance is constant over every pixel's cell of the latitude-longitude grid, so
/// that sampling by importance is exact.
class EnvironmentSampler {
 public:
  explicit EnvironmentSampler(const EnvironmentLight& light);

  /// W/(m² sr) seen in a unit direction.
  Rgb radiance(const Vec3& direction) const;
  /// ∫ radiance over the sphere, averaged over the channels, W/m².
  double integral() const { return integral_; }

  /// A direction for a receiver with this unit normal: cosine-weighted where the radiance is constant, else in proportion to
  /// the radiance over the whole sphere.
  Vec3 sample(const Vec3& normal, Vec2 u) const;
  /// Its density, 1/sr.
  float pdf(const Vec3& normal, const Vec3& direction) const;

 private:
  struct Cell {
    int row, column;
  };
  Cell cell_of(const Vec3& direction) const;
  double cell_solid_angle(int row) const;
  void build_table();

  Rgb factor_;
  std::shared_ptr<const EnvironmentImage> image_;
  float rotation_;  ///< radians about +y
  double integral_ = 0.0;
  std::vector<float> rows_up_to_;     ///< cumulative share of the rows; rows + 1 values from 0 to 1
  std::vector<float> columns_up_to_;  ///< within each row; columns + 1 values per row
};

}  // namespace gibench
