/// Loading a scene: NAME.scene.json, or a bare model file.
#pragma once

#include <filesystem>

#include "common/scene/scene.h"
#include "common/scene_io/models/read_model.h"

namespace gibench {

/// Reads, validates, recentres and tessellates. A relative path is looked up from the working folder, then
/// under each folder of GIBENCH_PATH. `read_bare_model` reads a model file that is given in place of a scene file. Throws
/// InputError with file, JSON path and how to fix it.
Scene load_scene(const std::filesystem::path& path, const ModelReader& read_bare_model = read_model);

}  // namespace gibench
