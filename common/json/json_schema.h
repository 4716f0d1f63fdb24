/// Validation of JSON against a JSON Schema (draft 7) with errors for people.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "common/json/json_place.h"

namespace gibench {

/// Throws InputError for the first violation: `place` and the path from there, what is wrong, and how to fix it:
/// what the schema's own description says (so write descriptions that follow "give"), or the known keys for an unknown one.
/// `remedy` is the fix where the schema has no description. References must be local ("#/definitions/…").
void check_against_json_schema(const nlohmann::json& value, const nlohmann::json& schema, const JsonPlace& place,
                               const std::string& remedy);

}  // namespace gibench
