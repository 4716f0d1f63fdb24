#include "bench/study/study_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "bench/measure/measuring_fields.h"
#include "bench/record/machine.h"
#include "common/core/hash.h"

namespace gibench {

namespace {

/// A file name that every file system takes.
std::string as_file_name(std::string text) {
  for (char& c : text)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '.' && c != '=' && c != '_' && c != '-') c = '-';
  return text;
}

/// The text as a file name that is not taken yet, and is now.
std::string free_name(const std::string& text, std::set<std::string>& taken) {
  const std::string wanted = as_file_name(text);
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
      runs.push_back({free_name(study.scenes[s].name + "." + study.variants[v].label, taken), s, v});
    }
  return runs;
}

std::vector<PlannedRelight> plan_relights(const Study& study) {
  std::vector<PlannedRelight> planned;
  std::set<std::string> taken;
  for (const PlannedRun& run : plan_runs(study)) taken.insert(run.id);
  for (std::size_t i = 0; i < study.relights.size(); ++i) {
    const StudyRelight& relight = study.relights[i];
    planned.push_back({free_name(study.scenes[relight.scene].name + ".relight." + relight.label, taken), i});
  }
  return planned;
}

std::string run_key(const Study& study, const PlannedRun& run, const WorkOptions& common, const std::string& scene_key,
                    const std::string& reference_state) {
  KeyBuilder key;
  key.add(version()).add(commit()).add(scene_key).add(reference_state);
  const StudyVariant& variant = study.variants[run.variant];
  key.add(variant.method);
  for (const auto& [name, value] : variant.parameters) key.add(name).add(to_text(value));
  for (const std::string& argument : plan_arguments(variant.plan)) key.add(argument);
  key.add(common.seed).add(common.threads);
  for (const std::string& argument : arguments_of(study.measuring)) key.add(argument);
  key.add(study.measuring.reference_seed);
  key.add(study.time_limit_seconds.value_or(0.0)).add(study.memory_limit_bytes.value_or(0));
  return key.hex();
}

std::string relight_key(const StudyRelight& relight, const WorkOptions& common, const std::string& scene_key,
                        const std::string& lights) {
  KeyBuilder key;
  key.add(version()).add(commit()).add(scene_key).add(lights).add(relight.method);
  for (const auto& [name, value] : relight.parameters) key.add(name).add(to_text(value));
  key.add(common.seed).add(common.threads);
  for (const std::string& argument : arguments_of(relight.options)) key.add(argument);
  return key.hex();
}

std::vector<std::string> plan_arguments(const PlanOptions& plan) {
  std::vector<std::string> arguments;
  if (!plan.effects.empty()) arguments.insert(arguments.end(), {"--effects", plan.effects});
  if (plan.tolerance > 0.0) arguments.insert(arguments.end(), {"--tolerance", fmt::format("{}", plan.tolerance)});
  return arguments;
}

}  // namespace gibench
