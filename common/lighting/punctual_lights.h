/// Point, spot and directional lights: what arrives from them on a facing surface.
#pragma once

#include <optional>
#include <variant>

#include "common/lighting/light_sample.h"
#include "common/lighting/light_tree.h"
#include "common/scene/scene.h"

namespace gibench {

using PunctualLight = std::variant<PointLight, SpotLight, DirectionalLight>;

/// The one way to the light, with pdf 1; no light (pdf 0) exactly at the light's position.
LightSample way_to(const PointLight& light, const Vec3& from);
LightSample way_to(const SpotLight& light, const Vec3& from);
LightSample way_to(const DirectionalLight& light, const Vec3& from);

/// W, averaged over the channels; of a directional light through a disc of the scene's radius (metres).
double power_of(const PunctualLight& light, double scene_radius);

/// What is estimated of a light beforehand; nothing for one at infinity.
std::optional<PlacedLight> place_of(const PunctualLight& light);

/// W/sr in the unit direction that light leaves in: constant inside the inner cone, smoothstep in the cosine to zero at
/// the outer one.
Rgb spot_intensity(const SpotLight& light, const Vec3& leaving);

}  // namespace gibench
