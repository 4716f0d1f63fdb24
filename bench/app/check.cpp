#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/options.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/cancellation.h"
#include "bench/measure/loaded_scene.h"
#include "bench/measure/run_method.h"
#include "bench/record/check_record.h"
#include "common/core/error.h"
#include "common/core/printable_text.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/geometry_report.h"
#include "common/reference/scene_key.h"
#include "methods/registry.h"

namespace gibench {

namespace {

PlanRecord plan_of(const Scene& scene, const SceneEffects& effects, const MethodChoice& choice) {
  const PlannedMethod planned = plan_method(effects, choice);
  return {choice.entry->name, planned.plan, planned.light_paths, planned.complete, planned.method->refusal(scene)};
}

std::vector<PlanRecord> plans_of(const Scene& scene, const SceneEffects& effects, const std::optional<MethodChoice>& chosen) {
  if (chosen) return {plan_of(scene, effects, *chosen)};
  std::vector<PlanRecord> plans;
  for (const MethodEntry& entry : all_methods()) plans.push_back(plan_of(scene, effects, {&entry, Parameters(entry.schema, {})}));
  return plans;
}

std::vector<MeasuredCamera> cameras_of(const Scene& scene) {
  std::vector<MeasuredCamera> cameras;
  for (const Camera& camera : scene.cameras) cameras.push_back({camera.name, camera.width, camera.height});
  return cameras;
}

void print_plan(const PlanRecord& method) {
  const std::string simulated = names_of(method.plan.simulated), missing = names_of(method.plan.missing);
  fmt::print("  {:<12} simulates {}{}{}\n", method.method, simulated.empty() ? "nothing" : simulated,
             missing.empty() ? "" : "; misses ", missing);
  fmt::print("  {:<12} light paths {}{}\n", "", method.light_paths, method.complete ? ", all that the scene has" : "");
  for (const SkippedEffect& skipped : method.plan.skipped)
    fmt::print("  {:<12} skips {}: {}\n", "", to_string(skipped.effect), skipped.why);
}

/// "35.2% (all of it fronts)", of the area that light can leave.
std::string share_of_sides(double fronts, double backs, double area) {
  const double all = fronts + backs;
  const double percent = area > 0.0 ? 100.0 * all / area : 0.0;
  if (backs == 0.0) return fmt::format("{:.1f}%", percent);
  return fmt::format("{:.1f}%, of which {:.1f}% are backs", percent, 100.0 * backs / all);
}

void print_spaces(const SpaceReport& spaces) {
  const bool told = !spaces.nothing_reached;
  fmt::print("  {:<20} {:.6g} m²\n", "can reflect light", spaces.area);
  fmt::print("  {:<20} {}\n", "lit", told ? share_of_sides(spaces.lit_fronts, spaces.lit_backs, spaces.area) : "nothing");
  fmt::print("  {:<20} {}\n", "seen by cameras", share_of_sides(spaces.seen_fronts, spaces.seen_backs, spaces.area));
  fmt::print("  {:<20} {}\n", "sealed from both", told ? share_of_sides(spaces.sealed, 0.0, spaces.area) : "not known");
}

void print_check(const CheckRecord& check) {
  fmt::print("{}: valid\n", check.scene);
  const nlohmann::ordered_json geometry = to_json(check.analysis.geometry);
  for (const auto& [name, value] : geometry.items()) fmt::print("  {:<20} {}\n", name, value.dump());
  const auto& [twins, opposite_twins, overlaps] = check.coincident;
  fmt::print("  {:<20} {} twins, {} opposite twins, {} overlaps\n", "coincident triangles", twins, opposite_twins, overlaps);
  print_spaces(check.spaces);
  for (const MeasuredCamera& camera : check.cameras)
    fmt::print("  camera '{}' {} × {}\n", camera.name, camera.width, camera.height);
  for (const std::string& warning : check.warnings) fmt::print("  warning: {}\n", printable_text(warning));
  fmt::print("what it calls for\n");
  for (const EffectEvidence& effect : check.analysis.effects)
    fmt::print("  {:<20} {:<4} {}\n", to_string(effect.effect), effect.called_for ? "yes" : "no", effect.why);
  fmt::print("  {:<20} {}\n", "bounces", check.analysis.bounce_bound.evidence);
  fmt::print("  {:<20} {}\n", "changes", check.changes);
  fmt::print("what each method simulates\n");
  for (const PlanRecord& method : check.methods)
    if (method.refusal) fmt::print("  {:<12} refuses: {}\n", method.method, *method.refusal);
    else print_plan(method);
}

struct CheckOptions {
  SceneOptions scene;
  MethodOptions method;
  std::optional<int> bounces;
  PlanOptions plan;
};

ExitStatus check(const CheckOptions& options, const CommonOptions& common) {
  const PlanLimits limits = limits_of(options.plan, options.bounces);
  const MethodOptions& asked = options.method;
  if (asked.method.empty() && !asked.settings.empty())
    throw InputError("--set", "is a parameter of no method", "name it with --method");
  if (asked.method.empty() && !asked.preset.empty())
    throw InputError("--preset", "is a preset of no method", "name it with --method");
  std::optional<MethodChoice> chosen;
  if (!asked.method.empty()) chosen = choose_method(asked);
  const LoadedScene loaded = load_world(options.scene, common.threads);
  const Scene& scene = loaded.scene();
  const auto start = std::chrono::steady_clock::now();
  const SceneEffects effects = analyse_effects(*loaded.world, limits);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  CheckRecord record;
  record.scene = scene.name, record.file = scene.file.string();
  record.analysis = {scene_key(scene), report_geometry(scene), effects.effects, BoundRecord::of(effects), seconds};
  record.coincident = count_coincidences(loaded.world->geometry().coplanar());
  Task task(TaskSettings{common.seed, common.threads, cancellation(), {}});
  record.spaces = report_spaces(*loaded.world, task);
  stop_if_cancelled();
  record.cameras = cameras_of(scene), record.lights = scene.lights.size(), record.warnings = scene.warnings;
  record.warnings.insert(record.warnings.end(), record.spaces.warnings.begin(), record.spaces.warnings.end());
  record.light_kinds = effects.lights, record.changes = names_of(effects.changes);
  record.methods = plans_of(scene, effects, chosen);
  record.exposure = scene.exposure;
  if (common.json) print_json(to_json(record));
  else print_check(record);
  return ExitStatus::done;
}

}  // namespace

void add_check(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "check", "Validates a scene: geometry, the effects it calls for, every method's plan");
  verb->group(verb_group::looking);
  set_pages(*verb, {"docs/own-scene.md", "docs/choosing-a-method.md"});
  const auto options = std::make_shared<CheckOptions>();
  add_scene_options(*verb, options->scene);
  verb->add_option("--method", options->method.method, "Only this method's plan")->type_name(value_kind::method);
  verb->add_option("--preset", options->method.preset, "A named set of that method's parameters, which --set overrides")
      ->type_name(value_kind::preset);
  verb->add_option("--set", options->method.settings, "A parameter of that method, name=value; may be given again")
      ->type_name(value_kind::setting)
      ->take_all();
  add_bounces_option(*verb, options->bounces);
  add_plan_options(*verb, options->plan);
  verb->callback([&call, options] { call.action = [&call, options] { return check(*options, call.common); }; });
}

}  // namespace gibench
