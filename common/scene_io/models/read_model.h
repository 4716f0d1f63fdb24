/// Reading model files of every format.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "common/scene_io/model.h"

namespace gibench {

/// OBJ, PLY, STL and glTF by the project's own readers (obj/, ply/, stl/, gltf/), all others through Assimp
/// (assimp/model_file.h). Names and warnings are printable (common/core/printable_text.h).
Model read_model(const std::filesystem::path& file, const std::string& place, bool with_materials);

/// read_model(), or what takes its place.
using ModelReader = std::function<Model(const std::filesystem::path& file, const std::string& place, bool with_materials)>;

/// Whether Assimp reads files of this name, which on a damaged file may crash, never end or take all memory: the project's own
/// readers do not.
bool is_read_by_assimp(const std::filesystem::path& file);

}  // namespace gibench
