/// All lights of a scene as one: emitting triangles, punctual lights and environments, sampled together.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/sobol.h"
#include "common/lighting/environment_sampler.h"
#include "common/lighting/light_choice.h"
#include "common/lighting/light_group.h"
#include "common/lighting/light_sample.h"
#include "common/lighting/light_tree.h"
#include "common/lighting/punctual_lights.h"
#include "common/lighting/triangle_emitter.h"
#include "common/ray/world.h"

namespace gibench {

/// Whether sample() also goes to punctual lights, or the caller visits each of them.
enum class PunctualLights { sampled, visited };

/// Immutable, shared by all threads. Of the lights that have a place, one is drawn half by what each of them gives at the
/// surface point (LightTree), half by power and evenly over the sources (LightChoice): what the estimate overlooks, and a faint
/// lamp where a bright one is hidden, keep their samples. Of directional lights, one is drawn half by irradiance on the
/// surface, half evenly over those that it faces.
class SceneLights {
 public:
  SceneLights(const World& world, const Lighting& lighting, PunctualLights punctual = PunctualLights::sampled);

  /// No light at all.
  bool empty() const { return groups_.empty() && punctual_.empty(); }
  /// Those with a light for sample() to find. Straight light is the sum over them.
  std::span<const LightGroup> groups() const { return groups_; }
  /// Whether sample() reads `choice`: the group has more than one light.
  bool has_choice(LightGroup group) const { return has_choice_[static_cast<std::size_t>(group)]; }
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

  /// A way from a surface point to one light of a group of groups(); `choice` is a 32-bit fraction of one that picks the
  /// light, `u` the place on it. No light (pdf 0) where the choice leads to none.
  LightSample sample(LightGroup group, const Vec3& position, const Vec3& normal, std::uint32_t choice, Vec2 u) const;
  /// The same with both from one pair: the first number picks the light, and where in that light's share it lies goes to the
  /// place, so that points which are even in the pair are even on every light.
  LightSample sample(LightGroup group, const Vec3& position, const Vec3& normal, SobolPair pair) const;
  /// The density, 1/sr, with which sample() would have found what a ray from `position` met: the emitting side of
  /// `triangle` at `distance` metres under this absolute cosine.
  float pdf_of_triangle(const Vec3& position, const Vec3& normal, std::uint32_t triangle, float distance, float cosine) const;
  /// The same for a ray that left the scene.
  float pdf_of_environment(const Vec3& normal, const Vec3& direction) const;

  std::size_t bytes() const;

 private:
  /// The lights that have a place, while they are being collected.
  struct Placed {
    std::vector<PlacedLight> lights;
    std::vector<double> power;          ///< W
    std::vector<std::uint32_t> source;  ///< an emitting object is one, its triangles share it
    std::uint32_t sources = 0;

    void add(const PlacedLight& light, double watts, std::uint32_t of_source) {
      lights.push_back(light), power.push_back(watts), source.push_back(of_source);
    }
  };
  void add_emitters(const World& world, Placed& placed);
  void add_punctual(const World& world, const std::vector<Light>& lights, PunctualLights punctual, Placed& placed);
  void add_environments(const std::vector<Light>& lights);
  void add_group(LightGroup group, std::size_t lights);
  LightTree::Choice choose_placed(const Vec3& position, const Vec3& normal, std::uint32_t choice) const;
  LightSample sample_placed(const LightTree::Choice& chosen, const Vec3& position, Vec2 u) const;
  LightSample sample_directional(const Vec3& position, const Vec3& normal, std::uint32_t choice) const;
  LightSample sample_environment(std::size_t chosen, const Vec3& normal, Vec2 u) const;

  std::vector<LightGroup> groups_;
  std::array<bool, most_light_groups> has_choice_{};
  std::vector<Rgb> emission_;  ///< of every material
  std::vector<TriangleEmitter> emitters_;
  std::vector<std::uint32_t> emitter_of_triangle_;  ///< empty without emitters
  std::vector<PunctualLight> punctual_;
  // Lights that have a place are numbered: emitters first, then point and spot lights. Both choices are empty for a single one.
  std::vector<std::uint32_t> placed_punctual_, directional_;  ///< indices into punctual_
  LightChoice placed_by_power_{{}, {}};
  LightTree placed_by_estimate_;
  std::vector<EnvironmentSampler> environments_;
  LightChoice environment_by_power_{{}, {}};
};

}  // namespace gibench
