/// The references that a study's runs are compared with: of all paths, and of those that its methods simulate.
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "bench/measure/cancellation.h"
#include "bench/measure/measuring_fields.h"
#include "bench/record/json_fields.h"
#include "bench/study/child_outcome.h"
#include "bench/study/for_each_job.h"
#include "bench/study/study_runner.h"
#include "common/reference/folder_replacement.h"

namespace gibench {

namespace fs = std::filesystem;

std::vector<std::string> StudyRunner::reference_arguments(std::size_t scene, const MeasuringOptions& measuring) const {
  const StudyReference& goal = *study_.reference;
  std::vector<std::string> arguments{"reference",        study_.scenes[scene].file.string(),
                                     "--references",     folders_.store().string(),
                                     "--replicas",       std::to_string(goal.replicas),
                                     "--seed",           std::to_string(measuring.reference_seed),
                                     "--remake-damaged", "--json"};
  const std::vector<std::string> where = arguments_of(measuring);
  arguments.insert(arguments.end(), where.begin(), where.end());
  if (goal.samples_per_replica) arguments.insert(arguments.end(), {"--samples", std::to_string(*goal.samples_per_replica)});
  if (goal.picture_samples) arguments.insert(arguments.end(), {"--picture-samples", std::to_string(*goal.picture_samples)});
  if (goal.target_error) arguments.insert(arguments.end(), {"--target-error", fmt::format("{}", *goal.target_error)});
  return arguments;
}

ChildLimits StudyRunner::reference_limits() const {
  const StudyReference& goal = *study_.reference;
  return {goal.time_limit_seconds ? goal.time_limit_seconds : study_.time_limit_seconds, study_.memory_limit_bytes};
}

StudyRunner::MadeReference StudyRunner::make_stored(std::size_t scene, const MeasuringOptions& measuring, const fs::path& out) {
  std::vector<std::string> arguments = reference_arguments(scene, measuring);
  if (!out.empty()) arguments.insert(arguments.end(), {"--out", out.string(), "--force"});
  const ChildLimits limits = reference_limits();
  MadeReference made{child(arguments, limits), {}, {}};
  made.reason = reason_of(made.child, limits);
  if (!succeeded(made.child)) return made;
  const Json printed = Json::parse(made.child.out);
  made.state = reference_facts_of(printed).state();
  std::string damage;
  read_field(printed, remade_key, damage);
  if (!damage.empty()) tell(fmt::format("{}: made anew: {}", study_.scenes[scene].name, damage));
  return made;
}

void StudyRunner::make_references() {
  if (!study_.reference) {
    for (SceneState& scene : scenes_) scene.references_known = true;
    return;
  }
  std::vector<bool> needed(scenes_.size(), false);
  for (std::size_t i = 0; i < runs_.size(); ++i)
    if (is_own(i)) needed[runs_[i].scene] = true;
  for_each_job(settings_.jobs, scenes_.size(), [&](std::size_t scene) {
    if (!needed[scene] || scenes_[scene].skipped) return;
    make_reference(scene);
    make_path_references(scene);
    scenes_[scene].references_known = true;
  });
  stop_if_cancelled();
}

void StudyRunner::make_reference(std::size_t scene) {
  SceneState& state = scenes_[scene];
  const std::string& name = study_.scenes[scene].name;
  const fs::path folder = folders_.reference(name), out = folders_.made_beside(folder);
  remove_made(out);
  const MadeReference made = make_stored(scene, study_.measuring, out);
  if (made.child.end == ChildEnd::cancelled) return remove_made(out);
  state.state = made.state;
  if (made.state) {
    replace_folder(out, folder);
    state.reference = reference_if_there(name);
    tell(fmt::format("{}: reference ready, {:.1f} s", name, made.child.seconds));
    return;
  }
  remove_made(out);
  state.earlier = state_of_finished(scene);
  state.reference_message = "no reference: " + made.reason;
  if (!state.earlier) state.reference.reset();
  else state.reference_message += "; errors are against the one of before";
  tell(fmt::format("{}: {}", name, state.reference_message));
  tell_not_done(fmt::format("{}: {}", name, state.reference_message));
}

/// Of the reference that the finished runs of a scene were held against.
std::optional<std::string> StudyRunner::state_of_finished(std::size_t scene) const {
  for (const PlannedRun& run : runs_) {
    if (run.scene != scene) continue;
    const auto recorded = read_process_record(folders_.run(run.id) / process_file);
    if (recorded && recorded->key == key_of(run) && recorded->reference) return recorded->reference;
  }
  return std::nullopt;
}

/// The light paths of the study's variants on a scene, where they are not all that the scene has.
std::map<std::size_t, std::string> StudyRunner::restricted_paths(std::size_t scene) const {
  std::map<std::size_t, std::string> paths;
  for (std::size_t v = 0; v < study_.variants.size(); ++v) {
    const StudyVariant& variant = study_.variants[v];
    if (!variant.runs_on(scene)) continue;
    std::vector<std::string> arguments{"check", study_.scenes[scene].file.string(), "--json", "--method", variant.method};
    for (const std::string& setting : variant.settings) arguments.insert(arguments.end(), {"--set", setting});
    const std::vector<std::string> plan = plan_arguments(variant.plan);
    arguments.insert(arguments.end(), plan.begin(), plan.end());
    if (study_.measuring.bounces) arguments.insert(arguments.end(), {"--bounces", std::to_string(*study_.measuring.bounces)});
    const ChildResult result = child(arguments, {});
    stop_if_cancelled();
    if (!succeeded(result)) continue;
    const CheckRecord check = check_record_of(Json::parse(result.out));
    const PlanRecord& method = check.methods.at(0);
    if (!method.refusal && !method.complete) paths[v] = method.light_paths;
  }
  return paths;
}

void StudyRunner::make_path_references(std::size_t scene) {
  SceneState& state = scenes_[scene];
  const std::string& name = study_.scenes[scene].name;
  state.paths = restricted_paths(scene);
  std::set<std::string> all;
  for (const auto& [variant, paths] : state.paths) all.insert(paths);
  for (const std::string& paths : all) {
    MeasuringOptions measuring = study_.measuring;
    measuring.light_paths = paths, measuring.bounces.reset();
    const MadeReference made = make_stored(scene, measuring, {});
    if (made.child.end == ChildEnd::cancelled) return;
    const std::string what =
        fmt::format("{}: reference of {} {}", name, paths, made.state ? "ready" : "not made: " + made.reason);
    tell(fmt::format("{}, {:.1f} s", what, made.child.seconds));
    if (made.state) state.path_states[paths] = *made.state;
    else tell_not_done(what);
  }
}

std::optional<std::string> StudyRunner::path_state(const PlannedRun& run) const {
  const SceneState& scene = scenes_[run.scene];
  const auto paths = scene.paths.find(run.variant);
  if (paths == scene.paths.end() || !scene.state) return std::nullopt;
  const auto state = scene.path_states.find(paths->second);
  return state == scene.path_states.end() ? std::nullopt : std::optional(state->second);
}

}  // namespace gibench
