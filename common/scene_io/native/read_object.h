/// Objects of a scene file, from their JSON. The JSON was validated against the schema before.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "common/json/json_place.h"
#include "common/scene/scene_assembler.h"

namespace gibench {

/// Adds one object, or one object for each material of a model file with its own materials. Model files are looked up
/// beside `folder`, then in GIBENCH_PATH. Throws InputError with place, problem and how to fix it.
void read_object(const nlohmann::json& object, const JsonPlace& place, const std::filesystem::path& folder,
                 SceneAssembler& assembler);

}  // namespace gibench
