#include "bench/record/query_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "common/core/enum_names.h"
#include "common/core/error.h"
#include "common/json/json_place.h"
#include "common/json/json_text.h"

namespace gibench {

namespace {

using nlohmann::json;

constexpr std::array quantities{Quantity::radiance, Quantity::irradiance, Quantity::radiosity, Quantity::accessibility};
constexpr double unit_tolerance = 1e-3;  // of a vector's length; within it the vector is normalised

const json& required(const json& object, const char* key, const JsonPlace& place) {
  const auto found = object.find(key);
  if (found == object.end()) throw InputError(place.text(), fmt::format("has no \"{}\"", key), "add it");
  return *found;
}

Vec3d read_vector(const json& object, const char* key, const JsonPlace& query) {
  const json& list = required(object, key, query);
  const JsonPlace place = query[key];
  if (!list.is_array() || list.size() != 3) throw InputError(place.text(), "is not a list of three numbers", "write [x, y, z]");
  Vec3d vector{0};
  for (int i = 0; i < 3; ++i) {
    const json& item = list[static_cast<std::size_t>(i)];
    if (!item.is_number()) throw InputError(place[static_cast<std::size_t>(i)].text(), "is not a number", "write a number");
    vector[i] = item.get<double>();
  }
  return vector;
}

Vec3d read_unit_vector(const json& object, const char* key, const JsonPlace& query) {
  const Vec3d vector = read_vector(object, key, query);
  const double length = glm::length(vector);
  if (!(std::fabs(length - 1.0) <= unit_tolerance))
    throw InputError(query[key].text(), fmt::format("has length {:.6g}", length), "write a vector of length 1");
  return vector / length;
}

std::string read_text(const json& object, const char* key, const JsonPlace& query) {
  const json& value = required(object, key, query);
  if (!value.is_string()) throw InputError(query[key].text(), "is not a string", "write it in quotation marks");
  return value.get<std::string>();
}

Quantity read_quantity(const json& object, const JsonPlace& query) {
  const std::string name = read_text(object, "quantity", query);
  std::string known;
  for (const Quantity quantity : quantities) {
    if (name == to_string(quantity)) return quantity;
    known += (known.empty() ? "" : ", ") + std::string(to_string(quantity));
  }
  throw InputError(query["quantity"].text(), "unknown quantity '" + name + "'", "known: " + known);
}

Component read_component(const json& object, const JsonPlace& query) {
  if (!object.contains("component")) return Component::total;
  const std::string name = read_text(object, "component", query);
  if (const auto component = find_named(all_components, name)) return *component;
  throw InputError(query["component"].text(), "unknown component '" + name + "'", "known: " + list_names(all_components));
}

std::optional<int> read_bounces(const json& object, const JsonPlace& query) {
  const auto found = object.find("bounces");
  if (found == object.end() || found->is_null()) return std::nullopt;
  if (!found->is_number_unsigned() || found->get<std::uint64_t>() > 1'000'000)
    throw InputError(query["bounces"].text(), "is not a number of reflections", "write a whole number from 0, or null for all");
  return found->get<int>();
}

void check_keys(const json& object, const JsonPlace& query) {
  constexpr std::array known{"id",        "point",   "normal", "quantity",        "direction",
                             "component", "bounces", "value",  "abs_uncertainty", "note"};
  for (const auto& [key, value] : object.items())
    if (std::find(known.begin(), known.end(), key) == known.end())
      throw InputError(query[key].text(), "unknown key", "known: id, point, normal, quantity, direction, component, bounces");
}

Query read_query(const json& object, const JsonPlace& place) {
  if (!object.is_object())
    throw InputError(place.text(), "is not an object", "write {\"id\", \"point\", \"normal\", \"quantity\"}");
  check_keys(object, place);
  Query query;
  query.place = place.text();
  query.id = read_text(object, "id", place);
  query.point = read_vector(object, "point", place);
  query.normal = read_unit_vector(object, "normal", place);
  query.quantity = read_quantity(object, place);
  query.component = read_component(object, place);
  query.bounces = read_bounces(object, place);
  if (query.quantity == Quantity::radiance) query.direction = Vec3(read_unit_vector(object, "direction", place));
  else if (object.contains("direction") && !object["direction"].is_null())
    throw InputError(place["direction"].text(), fmt::format("{} has no direction", to_string(query.quantity)), "leave it out");
  return query;
}

json rgb_json(const Rgb& value) { return {value.r, value.g, value.b}; }

}  // namespace

const char* to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::radiance: return "radiance";
    case Quantity::irradiance: return "irradiance";
    case Quantity::radiosity: return "radiosity";
    case Quantity::accessibility: return "accessibility";
  }
  return "unknown";
}

std::vector<Query> parse_queries(const std::string& text, const std::string& file) {
  const json parsed = parse_json(text, file);
  const JsonPlace top(file);
  if (!parsed.is_object()) throw InputError(top.text(), "is not an object", "write {\"queries\": [ … ]}");
  const json& list = required(parsed, "queries", top);
  if (!list.is_array()) throw InputError(top["queries"].text(), "is not a list", "write \"queries\": [ … ]");
  std::vector<Query> queries;
  for (std::size_t i = 0; i < list.size(); ++i) queries.push_back(read_query(list[i], top["queries"][i]));
  return queries;
}

nlohmann::ordered_json answers_json(const std::vector<Query>& queries, const std::vector<QueryAnswer>& answers) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (std::size_t i = 0; i < queries.size(); ++i) {
    nlohmann::ordered_json answer{{"id", queries[i].id}, {"value", rgb_json(answers[i].value)}};
    answer["standard_error"] = answers[i].standard_error ? nlohmann::ordered_json(rgb_json(*answers[i].standard_error)) : nullptr;
    list.push_back(std::move(answer));
  }
  return {{"queries", std::move(list)}};
}

}  // namespace gibench
