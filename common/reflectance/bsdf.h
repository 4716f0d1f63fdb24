/// What a surface does to light: the lobes of one material, evaluated and sampled together. Directions are unit,
/// leave the surface, and are given in the frame whose z axis is the normal of the lit side.
#pragma once

#include "common/reflectance/diffuse_lobe.h"
#include "common/reflectance/ggx_lobe.h"
#include "common/reflectance/phong_lobe.h"
#include "common/scene/scene.h"

namespace gibench {

/// The value and the sampling density of one pair of directions; both zero at or below the horizon.
struct BsdfValue {
  Rgb value;         ///< f, 1/sr, without the cosine
  float pdf = 0.0F;  ///< of sample() giving `in` for `out`, 1/sr
};

struct BsdfSample {
  Vec3 in{0.0F};       ///< where light is looked for
  Rgb weight;          ///< f · cos / pdf; a mirror's reflectance; black where nothing comes of the sample
  float pdf = 0.0F;    ///< 1/sr; 0 for a mirror
  bool delta = false;  ///< a mirror: no other direction contributes, and no light sample can hit this one
};

/// Flat, copied by value: one for each material.
class SurfaceBsdf {
 public:
  SurfaceBsdf() = default;
  explicit SurfaceBsdf(const Material& material);
  /// A Lambertian surface; an albedo of π makes a sensor of irradiance, whose f is 1.
  static SurfaceBsdf diffuse(const Rgb& albedo);

  bool is_delta() const { return kind_ == Bsdf::mirror; }
  bool is_diffuse() const { return kind_ == Bsdf::diffuse; }
  /// Reflects nothing at all.
  bool is_black() const;
  const Rgb& diffuse_albedo() const { return diffuse_.albedo; }

  /// Zero for a mirror.
  BsdfValue evaluate(const Vec3& out, const Vec3& in) const;
  /// Draws a direction with a density near f · cos: `choice` picks the lobe, `u` the direction, all in [0, 1).
  BsdfSample sample(const Vec3& out, float choice, Vec2 u) const;

 private:
  float specular_share(const Vec3& out) const;

  Bsdf kind_ = Bsdf::diffuse;
  DiffuseLobe diffuse_;
  PhongLobe phong_;
  GgxLobe ggx_;
  Rgb mirror_;  ///< reflectance
};

}  // namespace gibench
