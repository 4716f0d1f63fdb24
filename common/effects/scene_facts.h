/// Facts about the parts of a scene, counted once: the basis of the effect analysis.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/light_paths/path_event.h"
#include "common/ray/world.h"

namespace gibench {

/// How many lights of each kind give light; black ones, and emitting materials without a surface, do not count.
struct LightCounts {
  std::size_t emitting_materials = 0;
  std::array<std::size_t, std::variant_size_v<Light>> of_kind{};  ///< in the order of light_kinds()

  std::size_t punctual() const;
  std::size_t background() const;
  std::size_t at_infinity() const;
  bool any() const { return emitting_materials + punctual() + background() > 0; }
  bool operator==(const LightCounts&) const = default;
};

/// What a scene holds of each thing that an effect depends on.
struct SceneFacts {
  LightCounts lights;
  std::string first_emitter;              ///< name of a material; empty: none
  std::string brightest_diffuse, glossy;  ///< likewise
  std::string two_sided, coloured;        ///< an object's name; a material's name or "the lights"
  float largest_albedo = 0.0F;            ///< diffuse
  double glossy_area = 0.0;               ///< share of the surfaces
  std::size_t glossy_materials = 0;
  bool grey_surfaces = true;  ///< what they reflect; emission belongs to the lights
  PathEvents events;          ///< that light paths of the scene are made of; diffuse always: a sensor is

  /// Of the surfaces of `world` under `lighting`, which may be another than the scene's own.
  SceneFacts(const World& world, const Lighting& lighting);
};

bool is_grey(const Lighting& lighting);

}  // namespace gibench
