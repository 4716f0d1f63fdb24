#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/options.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/loaded_scene.h"
#include "bench/measure/run_method.h"
#include "bench/record/run_record.h"
#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/geometry_report.h"
#include "common/reference/scene_key.h"
#include "common/scene/light_kinds.h"
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

/// A method's plan and the light paths that it means, or why it refuses the scene.
Json plan_json(const Scene& scene, const SceneEffects& effects, const MethodChoice& choice, const std::string& label) {
  const PlannedMethod planned = plan_method(effects, choice);
  Json json{
      {"method", label}, {"plan", to_json(planned.plan)}, {"light_paths", planned.light_paths}, {"complete", planned.complete}};
  if (const auto why = planned.method->refusal(scene)) json["refusal"] = *why;
  return json;
}

Json plans_json(const Scene& scene, const SceneEffects& effects, const std::optional<MethodChoice>& chosen) {
  Json list = Json::array();
  if (chosen) list.push_back(plan_json(scene, effects, *chosen, chosen->entry->name));
  else
    for (const MethodEntry& entry : all_methods())
      list.push_back(plan_json(scene, effects, {&entry, Parameters(entry.schema, {})}, entry.name));
  return list;
}

Json bound_json(const SceneEffects& effects) {
  Json json{{"tolerance", effects.limits.tolerance > 0.0 ? effects.limits.tolerance : usual_tolerance}};
  if (effects.bound.most) json["most"] = *effects.bound.most;
  json["binds"] = effects.limits.tolerance > 0.0 && effects.bound.most.has_value();
  json["evidence"] = effects.bound.why;
  return json;
}

Json lights_json(const LightCounts& lights) {
  Json json{{"emitting_materials", lights.emitting_materials}};
  for (std::size_t kind = 0; kind < lights.of_kind.size(); ++kind) json[light_kinds()[kind].name] = lights.of_kind[kind];
  return json;
}

Json geometry_json(const World& world) {
  Json json = to_json(report_geometry(world.scene()));
  const CoincidenceCounts coincident = count_coincidences(world.geometry().coplanar());
  json["coincident_twins"] = coincident.twins;
  json["coincident_opposite_twins"] = coincident.opposite_twins;
  json["coincident_overlaps"] = coincident.overlaps;
  return json;
}

Json cameras_json(const Scene& scene) {
  Json list = Json::array();
  for (const Camera& camera : scene.cameras)
    list.push_back({{"name", camera.name}, {"resolution", {camera.width, camera.height}}});
  return list;
}

void print_plan(const std::string& name, const Json& method) {
  const Json& plan = method["plan"];
  const auto names = [&](const char* what) {
    return fmt::format("{}", fmt::join(plan[what].get<std::vector<std::string>>(), ", "));
  };
  const std::string simulated = names("simulated"), missing = names("missing");
  fmt::print("  {:<12} simulates {}{}{}\n", name, simulated.empty() ? "nothing" : simulated, missing.empty() ? "" : "; misses ",
             missing);
  fmt::print("  {:<12} light paths {}{}\n", "", method["light_paths"].get<std::string>(),
             method["complete"].get<bool>() ? ", all that the scene has" : "");
  for (const Json& skipped : plan["skipped"])
    fmt::print("  {:<12} skips {}: {}\n", "", skipped["effect"].get<std::string>(), skipped["why"].get<std::string>());
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
  fmt::print("  {:<20} {}\n", "bounces", check["bounce_bound"]["evidence"].get<std::string>());
  fmt::print("  {:<20} {}\n", "changes", check["changes"].get<std::string>());
  fmt::print("what each method simulates\n");
  for (const Json& method : check["methods"]) {
    const auto name = method["method"].get<std::string>();
    if (method.contains("refusal")) {
      fmt::print("  {:<12} refuses: {}\n", name, method["refusal"].get<std::string>());
      continue;
    }
    print_plan(name, method);
  }
}

struct CheckOptions {
  std::string scene, method;
  std::vector<std::string> settings;
  std::optional<int> bounces;
  PlanOptions plan;
};

ExitStatus check(const CheckOptions& options, const CommonOptions& common) {
  const PlanLimits limits = limits_of(options.plan, options.bounces);
  if (options.method.empty() && !options.settings.empty())
    throw InputError("--set", "is a parameter of no method", "name it with --method");
  std::optional<MethodChoice> chosen;
  if (!options.method.empty()) chosen = choose_method(options.method, options.settings);
  const LoadedScene loaded = load_world(options.scene, common.threads);
  const Scene& scene = loaded.scene();
  const auto start = std::chrono::steady_clock::now();
  const SceneEffects effects = analyse_effects(*loaded.world, limits);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  Json json{{"scene", scene.name},
            {"file", scene.file.string()},
            {"key", scene_key(scene)},
            {"geometry", geometry_json(*loaded.world)},
            {"cameras", cameras_json(scene)},
            {"lights", scene.lights.size()},
            {"warnings", scene.warnings},
            {"light_kinds", lights_json(effects.lights)},
            {"effects", evidence_json(effects)},
            {"bounce_bound", bound_json(effects)},
            {"changes", names_of(effects.changes)},
            {"analysis_seconds", seconds},
            {"methods", plans_json(scene, effects, chosen)}};
  if (scene.exposure) json["exposure"] = to_json(*scene.exposure);
  if (common.json) print_json(json);
  else print_check(json);
  return ExitStatus::done;
}

}  // namespace

void add_check(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "check", "Validates a scene: geometry, the effects it calls for, every method's plan");
  verb->group(verb_group::looking);
  set_pages(*verb, {"docs/own-scene.md", "docs/choosing-a-method.md"});
  const auto options = std::make_shared<CheckOptions>();
  add_scene_argument(*verb, options->scene);
  verb->add_option("--method", options->method, "Only this method's plan")->type_name(value_kind::method);
  verb->add_option("--set", options->settings, "A parameter of that method, name=value; may be given again")
      ->type_name(value_kind::setting)
      ->take_all();
  add_bounces_option(*verb, options->bounces);
  add_plan_options(*verb, options->plan);
  verb->callback([&call, options] { call.action = [&call, options] { return check(*options, call.common); }; });
}

}  // namespace gibench
