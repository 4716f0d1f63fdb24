#include "common/json/schema_validation.h"

#include <nlohmann/json.hpp>
#include <valijson/adapters/nlohmann_json_adapter.hpp>
#include <valijson/schema.hpp>
#include <valijson/schema_parser.hpp>
#include <valijson/validation_results.hpp>
#include <valijson/validator.hpp>

namespace gibench {

namespace {

using nlohmann::json;
using Adapter = valijson::adapters::NlohmannJsonAdapter;

bool validate(const json& schema_json, const json& value, valijson::ValidationResults* results) {
  valijson::Schema schema;
  valijson::SchemaParser(valijson::SchemaParser::kDraft7).populateSchema(Adapter(schema_json), schema);
  return valijson::Validator(valijson::Validator::kStrongTypes).validate(schema, Adapter(value), results);
}

}  // namespace

std::optional<SchemaViolation> first_violation(const json& schema, const json& value) {
  valijson::ValidationResults results;
  if (validate(schema, value, &results)) return std::nullopt;
  const valijson::ValidationResults::Error& first = *results.begin();
  return SchemaViolation{first.context, first.description};
}

bool holds(const json& schema, const json& value) { return validate(schema, value, nullptr); }

}  // namespace gibench
