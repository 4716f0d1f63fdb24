/// Reading a JSON Schema: which of its parts apply to a value, and what a value breaks there.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace gibench {

/// Schema objects that apply to one value, the most particular first.
using SchemaNodes = std::vector<const nlohmann::json*>;

/// `schema` and what it refers to for this value: its $ref, allOf, and the branch of if/then/else that the
/// value takes. `root` holds the definitions.
SchemaNodes applicable_nodes(const nlohmann::json& root, const nlohmann::json& schema, const nlohmann::json& value);

/// The nodes that apply to an element of `value`: that of a key, or that of a list (key empty).
SchemaNodes nodes_of_element(const nlohmann::json& root, const SchemaNodes& nodes, const std::string& key,
                             const nlohmann::json& element);

/// What is wrong, and what to write instead (empty where the schema does not say).
struct BrokenRule {
  std::string problem, remedy;
};
/// The first rule that a value itself breaks (its elements are left alone).
std::optional<BrokenRule> broken_rule(const nlohmann::json& root, const SchemaNodes& nodes, const nlohmann::json& value);

}  // namespace gibench
