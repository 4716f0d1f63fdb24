#include "common/scene_io/gltf/lights.h"

#include <algorithm>
#include <cmath>

#include "common/core/names.h"

namespace gibench {

namespace {

Rgb strength_of(const GltfValue& light) {
  const auto colour = light.numbers_or<3>("color", {1.0, 1.0, 1.0});
  const double intensity = light.number_or("intensity", 1.0);
  const auto channel = [&](std::size_t i) { return static_cast<float>(std::max(0.0, colour[i] * intensity)); };
  const Rgb strength{channel(0), channel(1), channel(2)};
  if (!is_finite(strength)) light.refuse("is stronger than single precision can hold");
  return strength;
}

/// Lights shine along −z of their node, whatever its scale.
std::optional<Vec3> direction_of(const GltfNode& node) {
  const Vec3d direction = node.to_file.linear * Vec3d(0.0, 0.0, -1.0);
  const double length = glm::length(direction);
  if (!(length > 0.0)) return std::nullopt;
  return Vec3(direction / length);
}

/// `is_clamped` becomes true where the cone is none that glTF allows: 0 ≤ inner ≤ outer ≤ π/2.
SpotLight spot_of(const GltfValue& light, const Vec3& direction, bool& is_clamped) {
  SpotLight spot;
  spot.direction = direction;
  spot.intensity = strength_of(light);
  double inner = 0.0, outer = pi_double / 4.0;
  if (const auto cone = light.find("spot")) {
    inner = cone->number_or("innerConeAngle", inner);
    outer = cone->number_or("outerConeAngle", outer);
  }
  constexpr double rounding = 1e-6;
  is_clamped = !(inner >= 0.0 && inner <= outer && outer <= 0.5 * pi_double + rounding);
  outer = std::clamp(outer, 0.0, 0.5 * pi_double);
  spot.cos_inner = static_cast<float>(std::cos(std::clamp(inner, 0.0, outer)));
  spot.cos_outer = static_cast<float>(std::cos(outer));
  return spot;
}

}  // namespace

void add_gltf_light(const GltfDocument& document, const GltfNode& node, Model& model) {
  const auto use = node.value.extension("KHR_lights_punctual");
  if (!use) return;
  const auto library = document.root().extension("KHR_lights_punctual");
  if (!library) use->refuse("names a light, and the file has no list of lights");
  const GltfValue light = library->at("lights").at(use->at("light").whole_number());
  const std::string type = light.at("type").text(), name = light.text_or("name", node.value.text_or("name", ""));
  const auto direction = direction_of(node);
  const auto warn = [&](const std::string& text) {
    model.warnings.push_back(document.file().filename().string() + ": light " + in_quotes(name) + ": " + text);
  };
  if (type != "point" && !direction) return warn("its node has no direction, it is left out");
  bool is_clamped = false;
  if (type == "point") model.lights.push_back({PointLight{Vec3(0.0F), strength_of(light)}, node.to_file.translation});
  else if (type == "spot") model.lights.push_back({spot_of(light, *direction, is_clamped), node.to_file.translation});
  else if (type == "directional")
    model.lights.push_back({DirectionalLight{*direction, strength_of(light)}, node.to_file.translation});
  else return warn("lights of type " + in_quotes(type) + " are left out");
  if (is_clamped) warn("its cone is clamped to its range");
  if (light.has("range")) warn("its range is not used: it lights what is farther away too");
}

}  // namespace gibench
