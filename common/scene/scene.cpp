#include "common/scene/scene.h"

#include <algorithm>

namespace gibench {

bool has_object(const Scene& scene, const std::string& name) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [&](const Object& object) { return object.name == name || object.name.starts_with(name + "/"); });
}

Lighting Lighting::of(const Scene& scene) {
  Lighting lighting;
  lighting.lights = scene.lights;
  for (const Material& material : scene.materials) lighting.emission.push_back(material.emission);
  return lighting;
}

}  // namespace gibench
