/// Validation of JSON against a JSON Schema by Valijson.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gibench {

/// What a value breaks, in Valijson's words.
struct SchemaViolation {
  std::vector<std::string> context;  ///< the path to the broken element: "<root>", "[objects]", "[2]", …
  std::string description;
};

/// The first that is found; empty for a valid value. References must be local ("#/definitions/…").
std::optional<SchemaViolation> first_violation(const nlohmann::json& schema, const nlohmann::json& value);

/// Whether a value is valid under a schema that needs no definitions of others.
bool holds(const nlohmann::json& schema, const nlohmann::json& value);

}  // namespace gibench
