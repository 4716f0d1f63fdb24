/// All lights of a scene as one: emitting triangles, punctual lights and environments, sampled together.
#pragma once

#include <cstdint>
#include <vector>

#include "common/core/sobol.h"
#include "common/lighting/environment_sampler.h"
#include "common/lighting/light_choice.h"
#include "common/lighting/light_sample.h"
#include "common/lighting/punctual_lights.h"
#include "common/lighting/triangle_emitter.h"
#include "common/ray/world.h"

namespace gibench {

/// Whether sample() also goes to punctual lights, or the caller visits each of them.
enum class PunctualLights { sampled, visited };

/// Immutable, shared by all threads.
class SceneLights {
 public:
  SceneLights(const World& world, const Lighting& lighting, PunctualLights punctual = PunctualLights::sampled);

  /// No light at all.
  bool empty() const { return choice_.empty() && punctual_.empty(); }
  /// sample() finds no light anywhere.
  bool nothing_to_sample() const { return choice_.empty(); }
  /// There are lights that a ray can meet: emitting triangles or an environment.
  bool can_be_hit() const { return !emitters_.empty() || !environments_.empty(); }
  std::size_t emitter_count() const { return emitters_.size(); }  ///< triangles
  /// The nearest emitting triangle that a ray meets, whatever else lies on its way: each of them is looked at.
  Hit emitter_met(const Vec3& origin, const Vec3& direction) const;
  std::size_t punctual_count() const { return punctual_.size(); }
  /// The way to one punctual light, with pdf 1.
  LightSample punctual(std::size_t light, const Vec3& position) const;

  /// Radiance that leaves the front of a triangle of this material, W/(m² sr).
  const Rgb& emission_of_material(std::uint32_t material) const { return emission_[material]; }
  /// Radiance of all environments in a unit direction, W/(m² sr).
  Rgb environment(const Vec3& direction) const;

  /// A way from a surface point to one light (not where there is nothing to sample); `choice` is a 32-bit fraction of one that
  /// picks the light, `u` the place on it.
  LightSample sample(const Vec3& position, const Vec3& normal, std::uint32_t choice, Vec2 u) const;
  /// The density, 1/sr, with which sample() would have found what a ray from `position` met: the emitting side of
  /// `triangle` at `distance` metres under this absolute cosine.
  float pdf_of_triangle(const Vec3& position, std::uint32_t triangle, float distance, float cosine) const;
  /// The same for a ray that left the scene.
  float pdf_of_environment(const Vec3& normal, const Vec3& direction) const;

  std::size_t bytes() const;

 private:
  void add_emitters(const World& world);
  void add_lights(const World& world, const std::vector<Light>& lights, PunctualLights punctual);
  LightSample sample_environment(const EnvironmentSampler& chosen, const Vec3& normal, Vec2 u) const;

  // Lights are numbered: emitters first, then punctual lights, then environments.
  std::vector<Rgb> emission_;  ///< of every material
  std::vector<TriangleEmitter> emitters_;
  std::vector<std::uint32_t> emitter_of_triangle_;  ///< empty without emitters
  std::vector<PunctualLight> punctual_;
  std::vector<EnvironmentSampler> environments_;
  std::vector<double> power_;          ///< W, while the choice is being built
  std::vector<std::uint32_t> source_;  ///< likewise
  LightChoice choice_{{}, {}};
};

}  // namespace gibench
