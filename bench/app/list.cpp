#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/scene_search.h"
#include "bench/record/run_record.h"
#include "common/core/error.h"
#include "common/core/names.h"
#include "common/core/overloaded.h"
#include "common/effects/effect_plan.h"
#include "common/method/method_session.h"
#include "common/metrics/metric_table.h"
#include "methods/registry.h"

namespace gibench {

namespace {

using Json = nlohmann::ordered_json;

struct ListOptions {
  std::string what = "methods", name;
};

Json parameter_json(const ParameterSpec& spec) {
  Json json{{"name", spec.name}, {"type", describe_type(spec)}, {"default", to_json(spec.default_value)}};
  const Overloaded is_number{[](bool) { return false; }, [](std::int64_t) { return true; }, [](double) { return true; },
                             [](const std::string&) { return false; }};
  if (std::visit(is_number, spec.default_value)) json["minimum"] = spec.minimum, json["maximum"] = spec.maximum;
  if (!spec.choices.empty()) json["choices"] = spec.choices;
  json["meaning"] = spec.meaning;
  return json;
}

Json preset_json(const Preset& preset) {
  Json settings = Json::object();
  for (const auto& [name, text] : preset.settings) settings[name] = text;
  return {{"name", preset.name}, {"meaning", preset.meaning}, {"parameters", std::move(settings)}};
}

Json effect_names(const EffectSet& effects) {
  Json names = Json::array();
  for (const Effect effect : effects) names.push_back(to_string(effect));
  return names;
}

Json method_json(const MethodEntry& entry) {
  const Capabilities can = make_session(entry, Parameters(entry.schema, {}))->capabilities();
  Json parameters = Json::array();
  for (const ParameterSpec& spec : entry.schema) parameters.push_back(parameter_json(spec));
  Json presets = Json::array();
  for (const Preset& preset : entry.presets) presets.push_back(preset_json(preset));
  return {{"name", entry.name},
          {"summary", entry.summary},
          {"source", entry.source},
          {"light_paths", entry.light_paths},
          {"effects", effect_names(can.effects)},
          {"computes", {{"direct", can.direct}, {"indirect", can.indirect}, {"variance", can.variance}}},
          {"parameters", std::move(parameters)},
          {"presets", std::move(presets)}};
}

std::vector<Json> entries(const std::string& what) {
  std::vector<Json> list;
  if (what == "methods")
    for (const MethodEntry& entry : all_methods()) list.push_back(method_json(entry));
  else if (what == "scenes")
    for (const KnownFile& scene : known_scenes()) list.push_back({{"name", scene.name}, {"file", scene.file.string()}});
  else if (what == "effects")
    for (const Effect effect : all_effects()) list.push_back({{"name", to_string(effect)}, {"meaning", meaning_of(effect)}});
  else
    for (const Metric& metric : all_metrics()) list.push_back({{"name", metric.name}, {"meaning", metric.meaning}});
  return list;
}

/// One entry for people: its fields, then a method's parameters as a table.
void print_entry(const Json& entry) {
  for (const auto& [key, value] : entry.items()) {
    if (key == "parameters" || key == "presets") continue;
    if (value.is_string()) {
      fmt::print("{:<12} {}\n", key, value.get<std::string>());
      continue;
    }
    std::string words;
    for (const auto& [name, item] : value.items()) {
      if (item.is_boolean() && !item.get<bool>()) continue;
      words += (words.empty() ? "" : ", ") + (item.is_string() ? item.get<std::string>() : name);
    }
    fmt::print("{:<12} {}\n", key, words.empty() ? "none" : words);
  }
  if (!entry.contains("parameters")) return;
  fmt::print("parameters (--set name=value)\n");
  for (const Json& parameter : entry["parameters"]) {
    const Json& value = parameter["default"];
    fmt::print("  {:<24} {:<34} default {:<10} {}\n", parameter["name"].get<std::string>(), parameter["type"].get<std::string>(),
               value.is_string() ? value.get<std::string>() : value.dump(), parameter["meaning"].get<std::string>());
  }
  if (entry["presets"].empty()) return;
  fmt::print("presets (--preset NAME)\n");
  for (const Json& preset : entry["presets"]) {
    std::string settings;
    for (const auto& [name, value] : preset["parameters"].items())
      settings += fmt::format(" {}={}", name, value.get<std::string>());
    fmt::print("  {:<24} {}:{}\n", preset["name"].get<std::string>(), preset["meaning"].get<std::string>(), settings);
  }
}

ExitStatus list_one(const std::vector<Json>& list, const ListOptions& options, bool json) {
  std::vector<std::string> names;
  for (const Json& entry : list) {
    names.push_back(entry["name"].get<std::string>());
    if (names.back() == options.name) {
      if (json) print_json(entry);
      else print_entry(entry);
      return ExitStatus::done;
    }
  }
  throw InputError("list " + options.what, "there is no '" + options.name + "'", known_names("known", options.name, names));
}

ExitStatus list_all(const std::vector<Json>& list, bool json) {
  if (json) {
    print_json(Json(list));
    return ExitStatus::done;
  }
  for (const Json& entry : list) fmt::print("{}\n", entry["name"].get<std::string>());
  return ExitStatus::done;
}

}  // namespace

void add_list(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "list", "Lists methods and their parameters, scenes, effects or metrics");
  verb->group(verb_group::looking);
  set_pages(*verb, {"docs/choosing-a-method.md", "scenes/README.md"});
  const auto options = std::make_shared<ListOptions>();
  take_one_of(verb->add_option("what", options->what, "Of what the names are listed"),
              {"methods", "scenes", "effects", "metrics"})
      ->capture_default_str();
  verb->add_option("name", options->name, "Only this one, in full")->type_name(value_kind::listed);
  verb->callback([&call, options] {
    call.action = [&call, options] {
      const std::vector<Json> list = entries(options->what);
      return options->name.empty() ? list_all(list, call.common.json) : list_one(list, *options, call.common.json);
    };
  });
}

}  // namespace gibench
