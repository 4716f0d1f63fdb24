/// Reading model files of every format.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// glTF 2.0 by the project's own reader (gltf/gltf_file.h), all others through Assimp (assimp/model_file.h).
Model read_model(const std::filesystem::path& file, const std::string& place, bool with_materials);

}  // namespace gibench
