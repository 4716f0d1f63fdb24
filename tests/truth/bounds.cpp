#include "bounds.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

namespace gibench::truth {

namespace {

using nlohmann::json;

const json& all_bounds() {
  static const json all = [] {
    std::ifstream file(std::filesystem::path(GIBENCH_TEST_DATA) / "bounds.json");
    return json::parse(file);
  }();
  return all;
}

/// [{"cause", "bounds": {ID: BOUND}}]
std::map<std::string, MeasuredBound> by_id(const json& causes) {
  std::map<std::string, MeasuredBound> result;
  for (const json& one : causes)
    for (const auto& [id, bound] : one.at("bounds").items())
      result[id] = {bound.get<double>(), one.at("cause").get<std::string>()};
  return result;
}

}  // namespace

std::string near_key(const std::string& case_id, const Question& question) {
  return question.bounces == 0 ? case_id + " direct" : case_id;
}

double Bounds::bound_of(const std::string& case_id, const Question& question, bool near) const {
  if (const auto own = questions.find(question.id); own != questions.end()) return own->second.bound;
  if (!near) return tolerance;
  const auto of_case = near_edges.find(near_key(case_id, question));
  return of_case == near_edges.end() ? near_tolerance : of_case->second.bound;
}

Bounds bounds_of(const std::string& rule) {
  const json& of_rule = all_bounds().contains(rule) ? all_bounds().at(rule) : all_bounds().at("new method");
  Bounds bounds;
  bounds.tolerance = of_rule.at("tolerance").get<double>();
  bounds.near_tolerance = of_rule.value("near_tolerance", bounds.tolerance);
  bounds.near_ceiling = of_rule.value("near_ceiling", bounds.near_tolerance);
  bounds.questions = by_id(of_rule.value("questions", json::array()));
  bounds.near_edges = by_id(of_rule.value("near_edges", json::array()));
  return bounds;
}

}  // namespace gibench::truth
