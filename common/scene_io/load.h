/// Loading a scene: NAME.scene.json, or a bare model file.
#pragma once

#include <filesystem>

#include "common/scene/scene.h"

namespace gibench {

/// Reads, validates, recentres and tessellates. A relative path is looked up from the working folder, then
/// under each folder of GIBENCH_PATH. Throws InputError with file, JSON path and how to fix it.
Scene load_scene(const std::filesystem::path& path);

}  // namespace gibench
