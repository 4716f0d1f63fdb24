/// Scene files NAME.scene.json, from their text to the scene in memory.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene/scene.h"

namespace gibench {

/// Validates, reads, recentres and tessellates. `place` names the text in messages, and relative files are looked up
/// beside `folder`. Throws InputError with place, JSON path and how to fix it.
Scene parse_scene(const std::string& json_text, const std::string& place, const std::filesystem::path& folder = ".");

/// "rooms/box.scene.json" → "box"; also for model files.
std::string scene_name_of(const std::filesystem::path& file);

}  // namespace gibench
