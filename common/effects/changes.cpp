#include "common/effects/changes.h"

#include <vector>

#include "common/core/overloaded.h"

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
  const Overloaded collect{
      [&](const MoveEdit& move) {
        if (move.translate != Vec3d(0.0) || move.rotate_degrees != Vec3d(0.0)) changes.insert(Change::motion);
      },
      [&](const MaterialEdit& edit) {
        for (Material& current : materials)
          if (current.name == edit.material) {
            compare(current, edit.after, changes);
            current = edit.after;
          }
        if (find(materials, edit.material) == nullptr) changes.insert(Change::material);
      },
      [&](const LightEdit&) { changes.insert(Change::lights); },
      [&](const DeformEdit&) { changes.insert(Change::deformation); },
  };
  for (const SceneEdit& edit : scene.edits) std::visit(collect, edit);
  return changes;
}

std::string names_of(const std::set<Change>& changes) {
  if (changes.empty()) return "none";
  std::string names;
  for (const Change change : changes) names += (names.empty() ? "" : ", ") + std::string(to_string(change));
  return changes.size() == 1 ? names + " only" : names;
}

}  // namespace gibench
