#include <deque>
#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "common/core/error.h"
#include "common/scene/scene_schema.h"
#include "common/scene/schema_nodes.h"

namespace gibench {

namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

/// The schema of one definition, with all definitions beside it for its references.
json schema_of(const std::string& definition) {
  json schema = json::parse(scene_schema_text());
  if (definition.empty()) return schema;
  return {{"$ref", "#/definitions/" + definition}, {"definitions", schema.at("definitions")}};
}

bool validate(const json& schema_json, const json& value, valijson::ValidationResults* results) {
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(schema_json), schema);
  return valijson::Validator(valijson::Validator::kStrongTypes).validate(schema, Adapter(value), results);
}

/// Follows valijson's context ("<root>", "[objects]", "[2]", …) through schema and value, and words the error.
[[noreturn]] void throw_first(const json& schema, const json& value, const valijson::ValidationResults::Error& error,
                              JsonPlace place) {
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
  throw InputError(place.text(), broken ? broken->first : error.description,
                   broken ? broken->second : "see scenes/scene.schema.json");
}

}  // namespace

bool holds(const json& schema, const json& value) { return validate(schema, value, nullptr); }

void check_against_schema(const json& value, const std::string& definition, const JsonPlace& place) {
  const json schema = schema_of(definition);
  valijson::ValidationResults results;
  if (validate(schema, value, &results)) return;
  throw_first(schema, value, *results.begin(), place);
}

}  // namespace gibench
