#include "common/effects/scene_facts.h"

#include <algorithm>

#include "common/scene/light_kinds.h"
#include "common/scene/material_kinds.h"

namespace gibench {

namespace {

bool is_grey(const Rgb& c) { return c.r == c.g && c.g == c.b; }

bool is_grey(const Material& m) { return is_grey(m.diffuse) && is_grey(m.specular) && is_grey(m.f0) && is_grey(m.reflectance); }

/// What a material does to light apart from diffuse reflection.
PathEvents glossy_event(const Material& m) {
  switch (gloss_of(m)) {
    case Gloss::none: return {};
    case Gloss::lobe: return PathEvent::glossy_reflection;
    case Gloss::mirror: return PathEvent::mirror_reflection;
  }
  return reflections;
}

template <class Test>
bool all_pixels(const EnvironmentImage& image, Test test) {
  return std::all_of(image.pixels.begin(), image.pixels.end(), test);
}

bool is_dark(const Light& light) {
  const auto parts = parts_of(light);
  if (is_black(*parts.strength)) return true;
  return parts.image != nullptr && all_pixels(*parts.image, [](const Rgb& p) { return is_black(p); });
}

bool is_grey(const Light& light) {
  const auto parts = parts_of(light);
  return is_grey(*parts.strength) &&
         (parts.image == nullptr || all_pixels(*parts.image, [](const Rgb& p) { return is_grey(p); }));
}

LightCounts count_lights(const std::vector<Light>& lights) {
  LightCounts counts;
  for (const Light& light : lights)
    if (!is_dark(light)) ++counts.of_kind[light.index()];
  return counts;
}

template <class Test>
std::size_t sum_over_kinds(const LightCounts& counts, Test test) {
  std::size_t sum = 0;
  for (std::size_t kind = 0; kind < counts.of_kind.size(); ++kind)
    if (test(light_kinds()[kind])) sum += counts.of_kind[kind];
  return sum;
}

/// m² of the faces of each material, one side.
std::vector<double> material_areas(const World& world) {
  const Scene& scene = world.scene();
  std::vector<double> area(scene.materials.size(), 0.0);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
    area[scene.objects[scene.triangle_object[t]].material] += double{world.area(t)};
  return area;
}

}  // namespace

std::size_t LightCounts::punctual() const {
  return sum_over_kinds(*this, [](const LightKind& kind) { return !kind.background; });
}
std::size_t LightCounts::background() const {
  return sum_over_kinds(*this, [](const LightKind& kind) { return kind.background; });
}
std::size_t LightCounts::at_infinity() const {
  return sum_over_kinds(*this, [](const LightKind& kind) { return kind.at_infinity; });
}

bool is_grey(const Lighting& lighting) {
  return std::all_of(lighting.lights.begin(), lighting.lights.end(), [](const Light& light) { return is_grey(light); }) &&
         std::all_of(lighting.emission.begin(), lighting.emission.end(), [](const Rgb& e) { return is_grey(e); });
}

SceneFacts::SceneFacts(const World& world, const Lighting& lighting) : lights(count_lights(lighting.lights)) {
  const Scene& scene = world.scene();
  const std::vector<double> area = material_areas(world);
  events = PathEvent::diffuse_reflection;
  for (std::size_t i = 0; i < area.size(); ++i) {
    if (!(area[i] > 0.0)) continue;
    const Material& m = scene.materials[i];
    if (!is_black(lighting.emission[i]) && lights.emitting_materials++ == 0) first_emitter = m.name;
    if (largest(m.diffuse) > largest_albedo) largest_albedo = largest(m.diffuse), brightest_diffuse = m.name;
    if (!is_grey(m)) grey_surfaces = false;
    if (coloured.empty() && !is_grey(m)) coloured = m.name;
    const PathEvents gloss = glossy_event(m);
    if (gloss.empty()) continue;
    if (glossy_materials++ == 0) glossy = m.name;
    glossy_area += area[i] / world.total_area();
    events |= gloss;
  }
  for (const Object& object : scene.objects)
    if (two_sided.empty() && object.two_sided && object.triangle_end > object.triangle_begin) two_sided = object.name;
  if (coloured.empty() && !is_grey(lighting)) coloured = "the lights";
  if (lights.punctual() > 0) events |= PathEvent::light;
  if (lights.emitting_materials > 0) events |= PathEvent::emitter;
  if (lights.background() > 0) events |= PathEvent::background;
}

}  // namespace gibench
