#include "common/json/json_schema.h"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

#include "common/core/error.h"
#include "common/json/schema_nodes.h"

namespace gibench {

namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

bool validate(const json& schema_json, const json& value, valijson::ValidationResults* results) {
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(schema_json), schema);
  return valijson::Validator(valijson::Validator::kStrongTypes).validate(schema, Adapter(value), results);
}

/// Follows valijson's context ("<root>", "[objects]", "[2]", …) through schema and value, and words the error.
[[noreturn]] void throw_in_words(const json& schema, const json& value, const valijson::ValidationResults::Error& error,
                                 JsonPlace place, const std::string& mend) {
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
  if (!broken) throw InputError(place.text(), error.description, mend);
  throw InputError(place.text(), broken->problem, broken->mend.empty() ? mend : broken->mend);
}

}  // namespace

bool holds(const json& schema, const json& value) { return validate(schema, value, nullptr); }

void check_against_json_schema(const json& value, const json& schema, const JsonPlace& place, const std::string& mend) {
  valijson::ValidationResults results;
  if (validate(schema, value, &results)) return;
  throw_in_words(schema, value, *results.begin(), place, mend);
}

}  // namespace gibench
