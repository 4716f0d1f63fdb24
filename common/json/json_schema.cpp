#include "common/json/json_schema.h"

#include <nlohmann/json.hpp>

#include "common/core/error.h"
#include "common/json/schema_nodes.h"
#include "common/json/schema_validation.h"

namespace gibench {

namespace {

using nlohmann::json;

/// Follows valijson's context ("<root>", "[objects]", "[2]", …) through schema and value, and words the error.
[[noreturn]] void throw_in_words(const json& schema, const json& value, const SchemaViolation& error, JsonPlace place,
                                 const std::string& remedy) {
  const json* here = &value;
  SchemaNodes nodes = applicable_nodes(schema, schema, value);
  for (std::size_t i = 1; i < error.context.size(); ++i) {
    std::string step = error.context[i];  // in brackets
    step.pop_back();
    step.erase(0, 1);
    const bool is_key = here->is_object();
    here = is_key ? &here->at(step) : &here->at(std::stoul(step));
    place = is_key ? place[step] : place[std::stoul(step)];
    nodes = nodes_of_element(schema, nodes, is_key ? step : std::string(), *here);
  }
  const auto broken = broken_rule(schema, nodes, *here);
  if (!broken) throw InputError(place.text(), error.description, remedy);
  throw InputError(place.text(), broken->problem, broken->remedy.empty() ? remedy : broken->remedy);
}

}  // namespace

void check_against_json_schema(const json& value, const json& schema, const JsonPlace& place, const std::string& remedy) {
  if (const auto violation = first_violation(schema, value)) throw_in_words(schema, value, *violation, place, remedy);
}

}  // namespace gibench
