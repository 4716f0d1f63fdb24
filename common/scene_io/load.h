/// Reading a scene: NAME.scene.json, or a bare model file that Assimp reads.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene/scene.h"

namespace gibench {

/// Reads, validates, recentres and tessellates. A relative path is looked up from the working folder, then
/// under each folder of GIBENCH_PATH. Throws InputError with file, JSON path and mend.
Scene load_scene(const std::filesystem::path& path);

/// The same from JSON text already in memory; `place` names it in messages and relative files are looked up
/// beside `folder`.
Scene parse_scene(const std::string& json_text, const std::string& place, const std::filesystem::path& folder = ".");

}  // namespace gibench
