/// Materials of Assimp's scenes.
#pragma once

#include <assimp/scene.h>

#include <filesystem>
#include <vector>

#include "common/scene_io/model.h"

namespace gibench {

/// Adds a ModelMaterial for every material of the scene, the default one for those that are not `used`. A material with
/// anything that is not simulated or out of range gives one warning.
void read_model_materials(const aiScene& scene, const std::filesystem::path& file, const std::vector<bool>& used, Model& model);

}  // namespace gibench
