#include "common/scene_io/assimp/model_units.h"

#include <cmath>

#include "common/scene_io/assimp/model_name.h"

namespace gibench {

namespace {

/// Metres of a unit of the file; 1 where it states none.
double metres_of_unit(const aiScene& scene) {
  float centimetres = 100.0F;
  if (scene.mMetaData != nullptr) scene.mMetaData->Get("UnitScaleFactor", centimetres);
  const double metres = static_cast<double>(centimetres) / 100.0;
  return metres > 0.0 && std::isfinite(metres) ? metres : 1.0;
}

}  // namespace

void convert_units(const aiScene& scene, const std::filesystem::path& file, Model& model) {
  const std::string extension = extension_of(file);
  if (extension == ".3mf" || extension == ".amf" || extension == ".blend")
    model.warnings.push_back(file.filename().string() + ": the unit that it states is not read, lengths are taken for metres");
  const double metres = metres_of_unit(scene);
  if (metres == 1.0) return;
  for (ModelPart& part : model.parts)
    for (Vec3d& vertex : part.geometry.vertices) vertex *= metres;
  for (ModelLight& light : model.lights) light.position *= metres;
  for (ModelCamera& camera : model.cameras) {
    const Vec3d view = camera.look_at - camera.position;
    camera.position *= metres;
    camera.look_at = camera.position + view;
  }
}

}  // namespace gibench
