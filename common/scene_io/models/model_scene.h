/// A bare model file as a scene, with the materials, lights and cameras that its format has.
#pragma once

#include <filesystem>
#include <string>

#include "common/scene/scene.h"
#include "common/scene_io/models/read_model.h"

namespace gibench {

/// One object for each material of each node. Throws InputError as read_model() does, which `read` is or stands for.
Scene load_model_scene(const std::filesystem::path& file, const std::string& name, const ModelReader& read);

}  // namespace gibench
