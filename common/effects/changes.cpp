#include "common/effects/changes.h"

#include <vector>

namespace gibench {

namespace {

const Material* find(const std::vector<Material>& materials, const std::string& name) {
  for (const Material& material : materials)
    if (material.name == name) return &material;
  return nullptr;
}

void compare(const Material& before, const Material& after, std::set<Change>& changes) {
  if (before.emission != after.emission) changes.insert(Change::lights);
  if (before.diffuse != after.diffuse) changes.insert(Change::albedo);
  if (before.bsdf != after.bsdf || before.specular != after.specular || before.exponent != after.exponent ||
      before.roughness != after.roughness || before.f0 != after.f0 || before.reflectance != after.reflectance)
    changes.insert(Change::material);
}

}  // namespace

const char* to_string(Change change) {
  switch (change) {
    case Change::lights: return "lights";
    case Change::albedo: return "albedo";
    case Change::material: return "material";
    case Change::motion: return "motion";
    case Change::deformation: return "deformation";
  }
  return "unknown";
}

std::set<Change> changes_of(const Scene& scene) {
  std::set<Change> changes;
  std::vector<Material> materials = scene.materials;
  for (const SceneEdit& edit : scene.edits) {
    if (const auto* move = std::get_if<MoveEdit>(&edit);
        move && (move->translate != Vec3d(0.0) || move->rotate_degrees != Vec3d(0.0)))
      changes.insert(Change::motion);
    if (std::holds_alternative<LightEdit>(edit)) changes.insert(Change::lights);
    if (std::holds_alternative<DeformEdit>(edit)) changes.insert(Change::deformation);
    const auto* material = std::get_if<MaterialEdit>(&edit);
    if (material == nullptr) continue;
    for (Material& current : materials)
      if (current.name == material->material) {
        compare(current, material->after, changes);
        current = material->after;
      }
    if (find(materials, material->material) == nullptr) changes.insert(Change::material);
  }
  return changes;
}

std::string names_of(const std::set<Change>& changes) {
  if (changes.empty()) return "none";
  std::string names;
  for (const Change change : changes) names += (names.empty() ? "" : ", ") + std::string(to_string(change));
  return changes.size() == 1 ? names + " only" : names;
}

}  // namespace gibench
