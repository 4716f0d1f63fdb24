/// A triangle that emits: points on it as seen from another point, and the density with which they are drawn.
#pragma once

#include <cstdint>

#include "common/core/rgb.h"
#include "common/lighting/light_sample.h"
#include "common/lighting/light_tree.h"
#include "common/ray/world.h"

namespace gibench {

/// Far triangles are sampled by area, near ones by solid angle: by area, the density per solid angle of a near emitter
/// falls to zero where it matters most. Which one is decided by the point alone, so that pdf() knows.
class TriangleEmitter {
 public:
  /// The world must outlive this.
  TriangleEmitter(const World& world, std::uint32_t triangle, bool two_sided, const Rgb& radiance);

  std::uint32_t triangle() const { return triangle_; }
  /// Flux of all emitting sides averaged over the channels, W.
  double power() const;
  /// What is estimated of it beforehand.
  PlacedLight as_placed() const;

  /// A way from `from` to a point of the triangle; no light (pdf 0) where its back is seen or another triangle is in front at
  /// that point. The pdf is of this triangle alone.
  LightSample sample(const Vec3& from, Vec2 u) const;
  /// Density, 1/sr, of the direction from `from` that meets the triangle at `distance` metres under this absolute cosine.
  float pdf(const Vec3& from, float distance, float cosine) const;
  /// Where the ray meets the triangle, from either side; edges belong to it.
  Hit met_by(const Vec3& origin, const Vec3& direction) const;

 private:
  double near_solid_angle(const Vec3& from) const;
  bool is_behind(Vec2 barycentrics, const Vec3& direction) const;
  LightSample toward(const Vec3& from, Vec2 barycentrics) const;

  Vec3 corner_, first_, second_;  ///< a corner and the two edges from it, metres
  Vec3 normal_;
  Vec3 centre_;
  float radius_ = 0.0F;  ///< metres, of the corners about the centre
  Rgb radiance_;
  float area_;          ///< m², one side
  float near_squared_;  ///< m²; below this squared distance from the centre the triangle counts as near
  float offset_;        ///< metres off the surface at which shadow rays end
  std::uint32_t triangle_;
  bool two_sided_;
  const CoincidentFaces* coincident_ = nullptr;  ///< of the world, where other triangles lie over this
};

}  // namespace gibench
