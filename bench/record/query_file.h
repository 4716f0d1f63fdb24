/// The questions and answers of `gibench query` as JSON.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/core/vec.h"
#include "common/method/quantity.h"

namespace gibench {

struct Query {
  std::string id;
  Vec3d point{0}, normal{0};  ///< in the scene file's coordinates, metres; unit
  Quantity quantity = Quantity::irradiance;
  Vec3 direction{0.0F};  ///< radiance only: unit, leaving the surface
  Component component = Component::total;
  std::optional<int> bounces;  ///< of this query alone; empty: as the call says
  std::string place;           ///< file and JSON path, for messages
};

struct QueryAnswer {
  Rgb value;
  std::optional<Rgb> standard_error;
};

/// Parses and checks. Throws InputError with file, JSON path and how to fix it. `value`, `abs_uncertainty` and `note` of a query
/// are accepted and ignored, so that a file may hold the answers that it expects.
std::vector<Query> parse_queries(const std::string& text, const std::string& file);

/// {"queries": [{"id", "value", "standard_error"}]} in the order of the queries.
nlohmann::ordered_json answers_json(const std::vector<Query>& queries, const std::vector<QueryAnswer>& answers);

const char* to_string(Quantity quantity);

}  // namespace gibench
