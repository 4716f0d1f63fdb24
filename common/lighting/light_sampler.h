/// Every light of a scene in flat tables: emission of hit surfaces, and directions drawn towards the lights.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "common/core/rgb.h"
#include "common/lighting/alias_table.h"
#include "common/lighting/environment.h"
#include "common/ray/world.h"

namespace gibench {

/// Light from one direction, before visibility.
struct LightSample {
  Rgb radiance;          ///< W/(m² sr); for a delta light the irradiance on a surface facing it, W/m²
  Vec3 direction{0.0F};  ///< unit, towards the light
  float pdf = 0.0F;      ///< 1/sr, the choice of the light included; for a delta light the probability of the choice
  bool delta = false;    ///< no other sampler can find it
  Ray shadow;            ///< anything on it blocks the light
};

/// Immutable, shared by all threads. A light is chosen by its power: W for areas and punctual lights; for the
/// environment and directional lights the power on the scene's bounding sphere.
class LightSampler {
 public:
  LightSampler(const World& world, const Lighting& lighting);

  /// Whether nothing emits.
  bool dark() const { return choice_.empty(); }
  bool has_environment() const { return !environments_.empty(); }
  /// Whether some light has an extent, so that hemisphere sampling can find it.
  bool has_extended() const { return !extended_choice_.empty(); }
  /// The lights without extent: each is found only by asking for it.
  const std::vector<std::uint32_t>& delta_lights() const { return delta_; }

  /// Radiance leaving a side of a triangle by its own emission.
  Rgb emission(std::uint32_t triangle, bool lit_side) const {
    return lit_side ? emission_[material_of_triangle_[triangle]] : Rgb();
  }
  Rgb environment(const Vec3& direction) const;

  /// One light chosen among all, one point or direction on it; empty where it cannot reach the sample's side.
  std::optional<LightSample> sample(const SurfaceSample& from, float u_light, Vec2 u) const;
  /// The same among the lights that have an extent, as if there were no others.
  std::optional<LightSample> sample_extended(const SurfaceSample& from, float u_light, Vec2 u) const;
  /// A delta light, by its entry in delta_lights(), chosen with certainty.
  std::optional<LightSample> delta_light(const SurfaceSample& from, std::uint32_t light) const;

  /// Density, 1/sr, with which sample() finds this emitting point from `from`.
  float pdf_of_hit(const Vec3& from, const SurfaceSample& hit) const;
  float pdf_of_environment(const Vec3& direction, const Vec3& normal) const;
  /// sample_extended()'s densities over sample()'s.
  float extended_factor() const { return extended_factor_; }

 private:
  enum class Kind : std::uint8_t { triangle, environment, punctual };
  struct Source {
    Kind kind;
    std::uint32_t index;  ///< of the triangle, the environment, or Lighting::lights
  };

  std::vector<double> add_triangles();
  void add_lights(std::vector<double>& power);
  void tabulate(const std::vector<double>& power);
  std::optional<LightSample> sample_source(const SurfaceSample& from, const AliasTable& table, float u_light, Vec2 u) const;
  std::optional<LightSample> sample_triangle(const SurfaceSample& from, std::uint32_t triangle, float probability, Vec2 u) const;
  std::optional<LightSample> sample_environment(const SurfaceSample& from, std::uint32_t index, float probability, Vec2 u) const;
  std::optional<LightSample> towards(const SurfaceSample& from, const Light& light, float probability) const;

  const World& world_;
  std::vector<Light> lights_;
  std::vector<Environment> environments_;
  std::vector<float> environment_probability_;  ///< of being chosen by sample()
  std::vector<Rgb> emission_;                   ///< of every material
  std::vector<std::uint32_t> material_of_triangle_;
  std::vector<float> area_density_;  ///< per triangle: sample()'s density on it, 1/m²
  std::vector<Source> sources_;
  std::vector<std::uint32_t> delta_;
  AliasTable choice_, extended_choice_;
  float extended_factor_ = 1.0F;
};

}  // namespace gibench
