/// A bare model file as a scene, with the materials, lights and cameras that its format has.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene/scene.h"

namespace gibench {

/// One object for each material of each node. Throws InputError as read_model() does.
Scene load_model_scene(const std::filesystem::path& file, const std::string& name);

}  // namespace gibench
