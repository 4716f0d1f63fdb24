/// Lights of a scene file, from their JSON. The JSON was validated against the schema before.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "common/json/json_place.h"
#include "common/scene/scene_assembler.h"

namespace gibench {

/// Pictures are looked up beside `folder`, then in GIBENCH_PATH. Throws InputError with place, problem and how to fix it.
Light read_light(const nlohmann::json& light, const JsonPlace& place, const std::filesystem::path& folder,
                 SceneAssembler& assembler);

}  // namespace gibench
