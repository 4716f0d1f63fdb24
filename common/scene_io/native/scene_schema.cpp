#include "common/scene_io/native/scene_schema.h"

#include <nlohmann/json.hpp>

#include "common/json/json_schema.h"
#include "common/scene_io/native/scene_schema_text.h"

namespace gibench {

void check_against_scene_schema(const nlohmann::json& value, const std::string& definition, const JsonPlace& place) {
  nlohmann::json schema = nlohmann::json::parse(scene_schema_text());
  if (!definition.empty()) schema = {{"$ref", "#/definitions/" + definition}, {"definitions", schema.at("definitions")}};
  check_against_json_schema(value, schema, place, "see scenes/scene.schema.json");
}

}  // namespace gibench
