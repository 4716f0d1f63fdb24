/// The references that a study's runs are compared with: of all paths, and of those that its methods simulate.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "bench/measure/cancellation.h"
#include "bench/measure/measuring_fields.h"
#include "bench/study/child_outcome.h"
#include "bench/study/study_runner.h"

namespace gibench {

std::vector<std::string> StudyRunner::reference_arguments(std::size_t scene, const MeasuringOptions& measuring) const {
  const StudyReference& goal = *study_.reference;
  std::vector<std::string> arguments{
      "reference",  study_.scenes[scene].file.string(), "--references", (folders_.root / "references" / "store").string(),
      "--replicas", std::to_string(goal.replicas),      "--seed",       std::to_string(measuring.reference_seed)};
  const std::vector<std::string> where = arguments_of(measuring);
  arguments.insert(arguments.end(), where.begin(), where.end());
  if (goal.samples_per_replica) arguments.insert(arguments.end(), {"--samples", std::to_string(*goal.samples_per_replica)});
  if (goal.target_error) arguments.insert(arguments.end(), {"--target-error", fmt::format("{}", *goal.target_error)});
  return arguments;
}

ChildLimits StudyRunner::reference_limits() const {
  const StudyReference& goal = *study_.reference;
  return {goal.time_limit_seconds ? goal.time_limit_seconds : study_.time_limit_seconds, study_.memory_limit_bytes};
}

/// The light paths of the study's variants on a scene, where they are not all that the scene has.
std::set<std::string> StudyRunner::restricted_paths(std::size_t scene) const {
  std::set<std::string> paths;
  for (const StudyVariant& variant : study_.variants) {
    if (!variant.runs_on(scene)) continue;
    std::vector<std::string> arguments{"check", study_.scenes[scene].file.string(), "--json", "--method", variant.method};
    for (const std::string& setting : variant.settings) arguments.insert(arguments.end(), {"--set", setting});
    const std::vector<std::string> plan = plan_arguments(variant.plan);
    arguments.insert(arguments.end(), plan.begin(), plan.end());
    if (study_.measuring.bounces) arguments.insert(arguments.end(), {"--bounces", std::to_string(*study_.measuring.bounces)});
    const ChildResult result = child(arguments, {}, "paths-" + study_.scenes[scene].name);
    stop_if_cancelled();
    if (!succeeded(result)) continue;
    const CheckRecord check = check_record_of(nlohmann::ordered_json::parse(result.out));
    const PlanRecord& method = check.methods.at(0);
    if (!method.refusal && !method.complete) paths.insert(method.light_paths);
  }
  return paths;
}

void StudyRunner::make_path_references(std::size_t scene) {
  const std::string& name = study_.scenes[scene].name;
  for (const std::string& paths : restricted_paths(scene)) {
    MeasuringOptions measuring = study_.measuring;
    measuring.light_paths = paths, measuring.bounces.reset();
    const ChildResult result = child(reference_arguments(scene, measuring), reference_limits(), "reference-" + name);
    if (result.end == ChildEnd::cancelled) return;
    const std::string reason = reason_of(result, reference_limits());
    tell(fmt::format("{}: reference of {} {}, {:.1f} s", name, paths, reason.empty() ? "ready" : "not made: " + reason,
                     result.seconds));
  }
}

}  // namespace gibench
