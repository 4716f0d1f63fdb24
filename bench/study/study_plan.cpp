#include "bench/study/study_plan.h"

#include <fmt/format.h>

#include <set>
#include <system_error>

#include "bench/measure/measuring_fields.h"
#include "bench/record/machine.h"
#include "common/core/hash.h"

namespace gibench {

namespace {

/// The name if it is not taken yet, else one that is near; taken it is now.
std::string free_name(const std::string& wanted, std::set<std::string>& taken) {
  std::string name = wanted;
  for (int copy = 2; !taken.insert(name).second; ++copy) name = wanted + "." + std::to_string(copy);
  return name;
}

}  // namespace

std::vector<PlannedRun> plan_runs(const Study& study) {
  std::vector<PlannedRun> runs;
  std::set<std::string> taken;
  for (std::size_t s = 0; s < study.scenes.size(); ++s)
    for (std::size_t v = 0; v < study.variants.size(); ++v) {
      if (!study.variants[v].runs_on(s)) continue;
      runs.push_back({free_name(folder_name(study.scenes[s], study.variants[v].label), taken), s, v});
    }
  return runs;
}

std::vector<PlannedRelight> plan_relights(const Study& study) {
  std::vector<PlannedRelight> planned;
  std::set<std::string> taken;
  for (const PlannedRun& run : plan_runs(study)) taken.insert(run.id);
  for (std::size_t i = 0; i < study.relights.size(); ++i) {
    const StudyRelight& relight = study.relights[i];
    planned.push_back({free_name(folder_name(study.scenes[relight.scene], relight_label(relight.label)), taken), i});
  }
  return planned;
}

std::string run_key(const Study& study, const PlannedRun& run, const WorkOptions& common, const std::string& scene_key) {
  KeyBuilder key;
  key.add(version()).add(commit()).add(scene_key);
  const StudyVariant& variant = study.variants[run.variant];
  key.add(variant.method);
  for (const auto& [name, value] : variant.parameters) key.add(name).add(to_text(value));
  for (const std::string& argument : plan_arguments(variant.plan)) key.add(argument);
  key.add(common.seed).add(common.threads);
  for (const std::string& argument : arguments_of(study.measuring)) key.add(argument);
  key.add(study.measuring.reference_seed).add(study.method_seeds);
  key.add(study.time_limit_seconds.value_or(0.0)).add(study.memory_limit_bytes.value_or(0));
  return key.hex();
}

std::string relight_key(const Study& study, const StudyRelight& relight, const WorkOptions& common, const std::string& scene_key,
                        const std::string& lights) {
  KeyBuilder key;
  key.add(version()).add(commit()).add(scene_key).add(lights).add(relight.method);
  for (const auto& [name, value] : relight.parameters) key.add(name).add(to_text(value));
  key.add(common.seed).add(common.threads);
  for (const std::string& argument : arguments_of(relight.options)) key.add(argument);
  key.add(study.time_limit_seconds.value_or(0.0)).add(study.memory_limit_bytes.value_or(0));
  return key.hex();
}

std::filesystem::path StudyFolders::made_beside(std::filesystem::path target) const {
  return target += shard.of == 1 ? std::string(".new") : fmt::format(".new-{}", shard.index);
}

void remove_made(const std::filesystem::path& made) {
  std::error_code ignored;
  for (const char* ending : {"", ".partial", ".lock"})
    std::filesystem::remove_all(std::filesystem::path(made) += ending, ignored);
}

std::vector<std::string> plan_arguments(const PlanOptions& plan) {
  std::vector<std::string> arguments;
  if (!plan.effects.empty()) arguments.insert(arguments.end(), {"--effects", plan.effects});
  if (plan.tolerance > 0.0) arguments.insert(arguments.end(), {"--tolerance", fmt::format("{}", plan.tolerance)});
  return arguments;
}

}  // namespace gibench
