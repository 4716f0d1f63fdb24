/// Edits of a scene file, from their JSON. The JSON was validated against the schema before.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "common/json/json_place.h"
#include "common/scene/scene_assembler.h"

namespace gibench {

/// Reads edits made one after the other, each on top of those before it. `lights` are the scene file's own. Throws
/// InputError with place, problem and how to fix it.
void read_edits(const nlohmann::json& edits, const nlohmann::json& lights, const JsonPlace& place,
                const std::filesystem::path& folder, SceneAssembler& assembler);

}  // namespace gibench
