/// The written-down form of scene files: scenes/scene.schema.json, part of the program.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/json/json_place.h"

namespace gibench {

/// Validates against one of the schema's definitions ("light", "material", …), or against the whole schema where
/// `definition` is empty; throws as check_against_json_schema().
void check_against_scene_schema(const nlohmann::json& value, const std::string& definition, const JsonPlace& place);

}  // namespace gibench
