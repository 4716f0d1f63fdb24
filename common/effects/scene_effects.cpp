#include "common/effects/scene_effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/geometry/convexity.h"
#include "common/geometry/mesh_topology.h"

namespace gibench {

namespace {

// Triangles; every pair is looked at, so larger meshes are taken as general: never wrong, at most not the least work.
constexpr std::size_t largest_arrangement = 4096;
constexpr float planarity = 1e-5F;  // of the scene's diagonal

/// What the scene's parts say, counted once.
struct Facts {
  std::vector<std::string> emitters;      ///< names of emitting materials on surfaces with area
  std::size_t punctual = 0;               ///< point, spot and directional lights that are not black
  std::size_t environments = 0;           ///< environment lights that are not black
  std::string brightest_diffuse, glossy;  ///< a material's name; empty: none
  float largest_albedo = 0.0F;

  bool lit() const { return !emitters.empty() || punctual > 0 || environments > 0; }
};

bool is_glossy(const Material& m) {
  switch (m.bsdf) {
    case Bsdf::diffuse: return false;
    case Bsdf::phong: return !is_black(m.specular);
    case Bsdf::ggx: return true;  // Schlick's term reflects at grazing angles whatever f0 is
    case Bsdf::mirror: return !is_black(m.reflectance);
  }
  return true;
}

std::vector<bool> materials_in_use(const World& world) {
  const Scene& scene = world.scene();
  std::vector<bool> used(scene.materials.size(), false);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
    if (world.area(t) > 0.0F) used[scene.objects[scene.triangle_object[t]].material] = true;
  return used;
}

void look_at_materials(const World& world, Facts& facts) {
  const std::vector<bool> used = materials_in_use(world);
  for (std::size_t i = 0; i < used.size(); ++i) {
    if (!used[i]) continue;
    const Material& m = world.scene().materials[i];
    if (!is_black(m.emission)) facts.emitters.push_back(m.name);
    if (facts.glossy.empty() && is_glossy(m)) facts.glossy = m.name;
    if (largest(m.diffuse) > facts.largest_albedo) facts.largest_albedo = largest(m.diffuse), facts.brightest_diffuse = m.name;
  }
}

bool is_dark(const EnvironmentLight& light) {
  if (is_black(light.radiance)) return true;
  if (!light.image) return false;
  const auto& pixels = light.image->pixels;
  return std::all_of(pixels.begin(), pixels.end(), [](const Rgb& p) { return is_black(p); });
}

/// Metres above the plane of a triangle, on its front; 0 for a degenerate one.
float height_above(const World& world, std::uint32_t triangle, const Vec3& point) {
  return glm::dot(world.normal(triangle), point - world.scene().vertices[world.scene().triangles[triangle].corners[0]]);
}

void look_at_lights(const Scene& scene, Facts& facts) {
  for (const Light& light : scene.lights) {
    const auto* point = std::get_if<PointLight>(&light);
    const auto* spot = std::get_if<SpotLight>(&light);
    const auto* sun = std::get_if<DirectionalLight>(&light);
    const auto* sky = std::get_if<EnvironmentLight>(&light);
    if ((point && !is_black(point->intensity)) || (spot && !is_black(spot->intensity)) || (sun && !is_black(sun->irradiance)))
      ++facts.punctual;
    if (sky && !is_dark(*sky)) ++facts.environments;
  }
}

std::string light_evidence(const Facts& facts) {
  std::string text;
  const auto append = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  if (!facts.emitters.empty())
    append(fmt::format("{} emitting material{} ('{}')", facts.emitters.size(), facts.emitters.size() == 1 ? "" : "s",
                       facts.emitters.front()));
  if (facts.punctual > 0)
    append(fmt::format("{} point, spot or directional light{}", facts.punctual, facts.punctual == 1 ? "" : "s"));
  if (facts.environments > 0) append("an environment light");
  return text;
}

/// The verdict on light that one surface throws on another; empty: nothing speaks against it.
std::string no_interreflection(Arrangement arrangement, std::optional<int> bounces) {
  if (bounces && *bounces == 0) return "0 bounces asked for";
  if (arrangement == Arrangement::no_mutual_sight) return "no surface sees the front of another";
  return {};
}

EffectEvidence diffuse_indirect(const Facts& facts, const std::string& prevented) {
  if (facts.brightest_diffuse.empty()) return {Effect::diffuse_indirect, false, "every diffuse albedo is 0"};
  if (!prevented.empty()) return {Effect::diffuse_indirect, false, prevented};
  return {Effect::diffuse_indirect, true,
          fmt::format("diffuse albedo up to {:.3g} ('{}')", facts.largest_albedo, facts.brightest_diffuse)};
}

EffectEvidence glossy(Effect effect, const Facts& facts, const std::string& prevented) {
  if (facts.glossy.empty()) return {effect, false, "no material is glossy"};
  if (!prevented.empty()) return {effect, false, prevented};
  return {effect, true, fmt::format("glossy material '{}'", facts.glossy)};
}

/// Called for wherever there is light: no method leaves out its visibility tests yet, so none may claim to.
EffectEvidence occlusion(Arrangement arrangement) {
  switch (arrangement) {
    case Arrangement::general: return {Effect::occlusion, true, "surfaces may hide one another"};
    case Arrangement::convex_room:
      return {Effect::occlusion, true, "one convex room: tested, though only lights outside can be hidden"};
    case Arrangement::no_mutual_sight:
      return {Effect::occlusion, true, "every surface lies behind every other: tested, though nothing is hidden"};
  }
  return {Effect::occlusion, true, {}};
}

}  // namespace

const EffectEvidence& SceneEffects::operator[](Effect effect) const {
  const auto found = std::find_if(effects.begin(), effects.end(), [&](const EffectEvidence& e) { return e.effect == effect; });
  GIBENCH_CHECK(found != effects.end(), "an analysis decides about every effect");
  return *found;
}

EffectSet SceneEffects::called_for() const {
  EffectSet set;
  for (const EffectEvidence& evidence : effects)
    if (evidence.called_for) set.insert(evidence.effect);
  return set;
}

Arrangement arrangement_of(const World& world) {
  const Scene& scene = world.scene();
  if (scene.triangles.size() > largest_arrangement) return Arrangement::general;
  const float tolerance = planarity * world.diagonal();
  const std::vector<std::uint32_t> weld = weld_vertices(scene.vertices, weld_tolerance(scene.vertices));
  if (!bounds_convex_set(scene.vertices, scene.triangles, weld, tolerance)) return Arrangement::general;
  // All vertices lie on one side of every face: on its front, or behind it, or (a flat plate) in its plane.
  float highest = 0.0F, lowest = 0.0F;
  bool two_sided = false;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    two_sided |= scene.objects[scene.triangle_object[t]].two_sided;
    for (const Triangle& other : scene.triangles)
      for (const std::uint32_t corner : other.corners) {
        const float height = height_above(world, t, scene.vertices[corner]);
        highest = std::max(highest, height);
        lowest = std::min(lowest, height);
      }
  }
  if (highest > tolerance) return Arrangement::convex_room;
  return two_sided && lowest < -tolerance ? Arrangement::general : Arrangement::no_mutual_sight;
}

SceneEffects analyse_effects(const World& world, std::optional<int> bounces) {
  SceneEffects result;
  result.max_bounces = bounces;
  Facts facts;
  look_at_materials(world, facts);
  look_at_lights(world.scene(), facts);
  if (!facts.lit()) {
    for (const Effect effect : all_effects()) result.effects.push_back({effect, false, "the scene has no light"});
    return result;
  }
  const Arrangement arrangement = arrangement_of(world);
  const std::string prevented = no_interreflection(arrangement, bounces);
  result.effects = {
      {Effect::direct, true, light_evidence(facts)},
      diffuse_indirect(facts, prevented),
      glossy(Effect::glossy_final_bounce, facts, {}),
      glossy(Effect::glossy_chain, facts, prevented),
      {Effect::environment, facts.environments > 0, facts.environments > 0 ? "an environment light" : "no environment light"},
      occlusion(arrangement)};
  return result;
}

}  // namespace gibench
