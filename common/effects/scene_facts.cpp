#include "common/effects/scene_facts.h"

#include <algorithm>

namespace gibench {

namespace {

bool is_grey(const Rgb& c) { return c.r == c.g && c.g == c.b; }

bool is_grey(const Material& m) { return is_grey(m.diffuse) && is_grey(m.specular) && is_grey(m.f0) && is_grey(m.reflectance); }

/// What a material does to light, besides diffusely.
PathEvents glossy_event(const Material& m) {
  switch (m.bsdf) {
    case Bsdf::diffuse: return {};
    case Bsdf::phong: return is_black(m.specular) ? PathEvents() : PathEvents(PathEvent::glossy_reflection);
    case Bsdf::ggx: return PathEvent::glossy_reflection;  // Schlick's term reflects at grazing angles whatever f0 is
    case Bsdf::mirror: return is_black(m.reflectance) ? PathEvents() : PathEvents(PathEvent::mirror_reflection);
  }
  return reflections;
}

bool is_dark(const EnvironmentLight& light) {
  if (is_black(light.radiance)) return true;
  if (!light.image) return false;
  const auto& pixels = light.image->pixels;
  return std::all_of(pixels.begin(), pixels.end(), [](const Rgb& p) { return is_black(p); });
}

bool is_grey(const Light& light) {
  if (const auto* point = std::get_if<PointLight>(&light)) return is_grey(point->intensity);
  if (const auto* spot = std::get_if<SpotLight>(&light)) return is_grey(spot->intensity);
  if (const auto* sun = std::get_if<DirectionalLight>(&light)) return is_grey(sun->irradiance);
  const auto& sky = std::get<EnvironmentLight>(light);
  if (!is_grey(sky.radiance) || !sky.image) return is_grey(sky.radiance);
  const auto& pixels = sky.image->pixels;
  return std::all_of(pixels.begin(), pixels.end(), [](const Rgb& p) { return is_grey(p); });
}

LightCounts count_lights(const std::vector<Light>& lights) {
  LightCounts counts;
  for (const Light& light : lights) {
    if (const auto* point = std::get_if<PointLight>(&light); point && !is_black(point->intensity)) ++counts.point;
    if (const auto* spot = std::get_if<SpotLight>(&light); spot && !is_black(spot->intensity)) ++counts.spot;
    if (const auto* sun = std::get_if<DirectionalLight>(&light); sun && !is_black(sun->irradiance)) ++counts.directional;
    if (const auto* sky = std::get_if<EnvironmentLight>(&light); sky && !is_dark(*sky)) ++counts.environment;
  }
  return counts;
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
  if (lights.point + lights.spot + lights.directional > 0) events |= PathEvent::light;
  if (lights.emitting_materials > 0) events |= PathEvent::emitter;
  if (lights.environment > 0) events |= PathEvent::background;
}

}  // namespace gibench
