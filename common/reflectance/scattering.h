/// What the front of a surface does to light, as lobes: diffuse, glossy (Phong or GGX) and mirror. A path takes one
/// lobe at a vertex, so that every light path has a class. Local frame: z is the normal.
#pragma once

#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "common/reflectance/ggx.h"
#include "common/reflectance/phong.h"
#include "common/scene/scene.h"

namespace gibench {

enum class Lobe { diffuse, glossy, mirror };

/// A direction drawn from one lobe.
struct LobeSample {
  Vec3 incoming{0.0F};  ///< unit, towards where the light comes from
  Rgb weight;           ///< BRDF · cosine / density of the lobe
  float pdf = 0.0F;     ///< of the lobe, 1/sr; 0 for the mirror
};

/// A material made ready for evaluation.
class Scattering {
 public:
  Scattering() = default;
  explicit Scattering(const Material& material);
  /// A surface that is only diffuse, as a receiver of irradiance is.
  static Scattering diffuse_only(const Rgb& albedo);

  const Rgb& diffuse() const { return diffuse_; }
  bool has(Lobe lobe) const { return probability(lobe) > 0.0F; }
  /// Probability with which a path takes the lobe; they sum to one, or to zero for black.
  float probability(Lobe lobe) const { return probability_[static_cast<int>(lobe)]; }
  /// The lobe at `u` in [0, 1); has() it unless the surface is black.
  Lobe choose(float u) const;

  /// BRDF · cos θi of a lobe, 1/sr; zero for the mirror and for directions below the surface.
  Rgb times_cosine(Lobe lobe, const Vec3& outgoing, const Vec3& incoming) const;
  /// Density of sample(lobe), 1/sr; zero for the mirror.
  float pdf(Lobe lobe, const Vec3& outgoing, const Vec3& incoming) const;
  /// Weight zero where the sampled direction carries nothing.
  LobeSample sample(Lobe lobe, const Vec3& outgoing, Vec2 u) const;

 private:
  enum class Glossy { none, phong, ggx };
  void weigh_lobes(float diffuse, float glossy, float mirror);

  Rgb diffuse_, mirror_;
  Glossy glossy_ = Glossy::none;
  PhongLobe phong_;
  GgxLobe ggx_;
  float probability_[3] = {0.0F, 0.0F, 0.0F};
};

}  // namespace gibench
