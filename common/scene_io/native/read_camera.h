/// Cameras of a scene file, from their JSON. The JSON was validated against the schema before.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "common/json/json_place.h"
#include "common/scene/scene_assembler.h"

namespace gibench {

/// Throws InputError with place, problem and how to fix it.
void read_cameras(const nlohmann::json& cameras, const JsonPlace& place, SceneAssembler& assembler);

}  // namespace gibench
