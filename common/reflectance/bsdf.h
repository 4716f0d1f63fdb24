/// The reflection of light by a surface: the lobes of one material, evaluated and sampled together. Directions are unit,
/// leave the surface, and are given in the frame whose z axis is the normal of the lit side.
#pragma once

#include <cstdint>

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

/// The same, lobe by lobe.
struct LobeValues {
  Rgb diffuse, specular;  ///< f of each, 1/sr, without the cosine
  float pdf = 0.0F;
};

/// Lobes that may scatter, as bits.
enum class Lobes : std::uint8_t { none = 0, diffuse = 1, specular = 2, both = 3 };
constexpr bool contains(Lobes lobes, Lobes one) { return (static_cast<unsigned>(lobes) & static_cast<unsigned>(one)) != 0; }
constexpr Lobes operator|(Lobes a, Lobes b) { return static_cast<Lobes>(static_cast<unsigned>(a) | static_cast<unsigned>(b)); }

/// A direction drawn in proportion to what the surface reflects.
struct BsdfSample {
  Vec3 in{0.0F};       ///< where light is looked for
  Rgb weight;          ///< f · cos / pdf; a mirror's reflectance; black where nothing comes of the sample
  float pdf = 0.0F;    ///< 1/sr; 0 for a mirror
  bool delta = false;  ///< a mirror: no other direction contributes, and no light sample can hit this one
};

/// Flat, copied by value: one for each material. No surface reflects more than it gets, from any direction and at any
/// roughness: where a ggx lobe lies over a diffuse part, see grazing_reflectance() (common/scene/material_kinds.h).
class SurfaceBsdf {
 public:
  SurfaceBsdf() = default;
  explicit SurfaceBsdf(const Material& material);
  /// What the material reflects beside its diffuse part. A material whose diffuse part is set to black is another: its lobe
  /// has room to reflect more.
  static SurfaceBsdf specular_part(const Material& material);
  /// A Lambertian surface; an albedo of π makes a sensor of irradiance, whose f is 1.
  static SurfaceBsdf diffuse(const Rgb& albedo);

  bool is_delta() const { return kind_ == Bsdf::mirror; }
  bool is_diffuse() const { return kind_ == Bsdf::diffuse; }
  /// Reflects nothing at all.
  bool is_black() const;
  const Rgb& diffuse_albedo() const { return diffuse_.albedo; }

  /// Zero for a mirror.
  BsdfValue evaluate(const Vec3& out, const Vec3& in) const;
  /// The lobes that may scatter alone, and the density of sampling those; zero for a mirror.
  LobeValues evaluate_lobes(const Vec3& out, const Vec3& in, Lobes lobes) const;
  /// Draws a direction with a density near f · cos of the lobes that may scatter: `choice` picks the lobe, `u` the
  /// direction, all in [0, 1).
  BsdfSample sample(const Vec3& out, float choice, Vec2 u, Lobes lobes = Lobes::both) const;

 private:
  float specular_share(const Vec3& out, Lobes lobes) const;
  // Of the lobe beside the diffuse one; a mirror's cannot be evaluated.
  float lobe_strength(const Vec3& out) const;
  BsdfValue lobe_value(const Vec3& out, const Vec3& in) const;
  Vec3 lobe_sample(const Vec3& out, Vec2 u) const;

  Bsdf kind_ = Bsdf::diffuse;
  DiffuseLobe diffuse_;
  PhongLobe phong_;
  GgxLobe ggx_;
  Rgb mirror_;  ///< reflectance
};

}  // namespace gibench
