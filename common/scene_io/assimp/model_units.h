/// The unit of length of model files.
#pragma once

#include <assimp/scene.h>

#include <filesystem>

#include "common/scene_io/model.h"

namespace gibench {

/// Converts a model to metres: FBX states how many centimetres its unit has. A warning names formats whose unit is not
/// read. (Assimp converts COLLADA itself; other formats have no unit, and their lengths are taken for metres.)
void convert_units(const aiScene& scene, const std::filesystem::path& file, Model& model);

}  // namespace gibench
