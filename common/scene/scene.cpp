#include "common/scene/scene.h"

#include <algorithm>

#include "common/scene/object_names.h"

namespace gibench {

bool has_object(const Scene& scene, const std::string& name) {
  return std::any_of(scene.objects.begin(), scene.objects.end(),
                     [&](const Object& object) { return stands_for(name, object.name); });
}

Lighting Lighting::of(const Scene& scene) {
  Lighting lighting;
  lighting.lights = scene.lights;
  for (const Material& material : scene.materials) lighting.emission.push_back(material.emission);
  return lighting;
}

}  // namespace gibench
