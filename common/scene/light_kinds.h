/// The facts of every kind of light that need no sampling. A kind without them does not compile.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <type_traits>
#include <variant>

#include "common/scene/scene.h"

namespace gibench {

/// The facts of one kind.
struct LightKind {
  const char* name;  ///< as scene files write it and records count it
  bool at_infinity;  ///< outside every scene: it gives a closed one nothing
  bool background;   ///< met by rays that leave the scene; all others are punctual and met by none
};

/// In the order of Light's alternatives.
const std::array<LightKind, std::variant_size_v<Light>>& light_kinds();
const LightKind& kind_of(const Light& light);
/// A light of the kind with this name, yet without its values; nothing for an unknown name.
std::optional<Light> light_of_kind(std::string_view name);

/// What lights are made of, whatever their kind. AnyLight: Light or const Light.
template <class AnyLight>
struct LightParts {
  template <class Value>
  using Part = std::conditional_t<std::is_const_v<AnyLight>, const Value, Value>*;

  Part<Rgb> strength;              ///< intensity, irradiance, or radiance: a factor on all that the light gives
  Part<Vec3> position = nullptr;   ///< relative to Scene::origin; null at infinity
  Part<Vec3> direction = nullptr;  ///< unit, the way the light travels; null where it travels in all
  const EnvironmentImage* image = nullptr;
};
LightParts<Light> parts_of(Light& light);
LightParts<const Light> parts_of(const Light& light);

}  // namespace gibench
