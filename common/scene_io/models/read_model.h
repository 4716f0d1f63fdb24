/// Reading model files of every format.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// OBJ, PLY, STL and glTF by the project's own readers (obj/, ply/, stl/, gltf/), all others through Assimp
/// (assimp/model_file.h). Names and warnings are printable (common/core/printable_text.h).
Model read_model(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
