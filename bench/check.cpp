#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "bench/loaded_scene.h"
#include "bench/measuring_options.h"
#include "bench/print_json.h"
#include "bench/run_record.h"
#include "bench/verbs.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/geometry_report.h"
#include "common/reference/reference_store.h"
#include "methods/registry.h"

namespace gibench {

namespace {

using Json = nlohmann::ordered_json;

Json evidence_json(const SceneEffects& effects) {
  Json list = Json::array();
  for (const EffectEvidence& e : effects.effects)
    list.push_back({{"effect", to_string(e.effect)}, {"called_for", e.called_for}, {"evidence", e.why}});
  return list;
}

/// Every method with its plan, or why it refuses the scene.
Json plans_json(const Scene& scene, const SceneEffects& effects) {
  Json list = Json::array();
  for (const MethodEntry& entry : all_methods()) {
    const auto method = entry.make(Parameters(entry.schema, {}));
    Json json{{"method", entry.name}, {"plan", to_json(plan_effects(effects, method->capabilities().effects))}};
    if (const auto why = method->refusal(scene)) json["refusal"] = *why;
    list.push_back(std::move(json));
  }
  return list;
}

Json cameras_json(const Scene& scene) {
  Json list = Json::array();
  for (const Camera& camera : scene.cameras)
    list.push_back({{"name", camera.name}, {"resolution", {camera.width, camera.height}}});
  return list;
}

void print_check(const Json& check) {
  fmt::print("{}: valid\n", check["scene"].get<std::string>());
  for (const auto& [name, value] : check["geometry"].items()) fmt::print("  {:<20} {}\n", name, value.dump());
  for (const Json& camera : check["cameras"])
    fmt::print("  camera '{}' {} × {}\n", camera["name"].get<std::string>(), camera["resolution"][0].dump(),
               camera["resolution"][1].dump());
  for (const Json& warning : check["warnings"]) fmt::print("  warning: {}\n", warning.get<std::string>());
  fmt::print("what it calls for\n");
  for (const Json& effect : check["effects"])
    fmt::print("  {:<20} {:<4} {}\n", effect["effect"].get<std::string>(), effect["called_for"].get<bool>() ? "yes" : "no",
               effect["evidence"].get<std::string>());
  fmt::print("what the methods make of it\n");
  for (const Json& method : check["methods"]) {
    const auto name = method["method"].get<std::string>();
    if (method.contains("refusal")) {
      fmt::print("  {:<12} refuses: {}\n", name, method["refusal"].get<std::string>());
      continue;
    }
    const auto simulated = method["plan"]["simulated"].get<std::vector<std::string>>();
    const auto missing = method["plan"]["missing"].get<std::vector<std::string>>();
    fmt::print("  {:<12} simulates {}{}{}\n", name, simulated.empty() ? "nothing" : fmt::format("{}", fmt::join(simulated, ", ")),
               missing.empty() ? "" : "; misses ", fmt::join(missing, ", "));
  }
}

ExitStatus check(const std::string& name, std::optional<int> bounces, const CommonOptions& common) {
  const LoadedScene loaded = load_world(name, common.threads);
  const Scene& scene = loaded.scene();
  const SceneEffects effects = analyse_effects(*loaded.world, bounces);
  Json json{{"scene", scene.name},
            {"file", scene.file.string()},
            {"key", scene_key(scene)},
            {"geometry", to_json(report_geometry(scene))},
            {"cameras", cameras_json(scene)},
            {"lights", scene.lights.size()},
            {"warnings", scene.warnings},
            {"effects", evidence_json(effects)},
            {"methods", plans_json(scene, effects)}};
  if (scene.exposure) json["exposure"] = to_json(*scene.exposure);
  if (common.json) print_json(json);
  else print_check(json);
  return ExitStatus::done;
}

}  // namespace

void add_check(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "check", "Validates a scene: geometry facts, what it calls for, every method's plan");
  struct Options {
    std::string scene;
    std::optional<int> bounces;
  };
  const auto options = std::make_shared<Options>();
  verb->add_option("scene", options->scene, "Scene file, model file or the name of a known scene")->required();
  add_bounces_option(*verb, options->bounces);
  verb->callback(
      [&call, options] { call.action = [&call, options] { return check(options->scene, options->bounces, call.common); }; });
}

}  // namespace gibench
