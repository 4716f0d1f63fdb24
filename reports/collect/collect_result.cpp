#include <cmath>

#include "common/core/error.h"
#include "reports/collect/collect.h"
#include "reports/collect/error_reading.h"
#include "reports/collect/json_reading.h"

namespace gibench::report {

std::optional<MeasuredError> error_of(const Json& entry) {
  const auto value = number_at(entry, "value");
  if (!value) return std::nullopt;
  MeasuredError error{.value = *value, .low = {}, .high = {}, .noise_floor = number_at(entry, "noise_floor")};
  if (const auto interval = entry.find("ci95"); interval != entry.end() && interval->is_array() && interval->size() == 2 &&
                                                (*interval)[0].is_number() && (*interval)[1].is_number()) {
    error.low = (*interval)[0].get<double>();
    error.high = (*interval)[1].get<double>();
  }
  const auto below = entry.find("below_noise_floor");
  error.below_noise_floor = below != entry.end() && below->is_boolean() && below->get<bool>();
  return error;
}

namespace {

Effects effects_of(const Json& entry) {
  Effects effects;
  effects.called_for = texts_at(entry, "called_for");
  effects.simulated = texts_at(entry, "simulated");
  effects.missing = texts_at(entry, "missing");
  if (const auto skipped = entry.find("skipped"); skipped != entry.end() && skipped->is_array())
    for (const Json& item : *skipped)
      effects.skipped.emplace_back(text_at(item, "effect").value_or(""), text_at(item, "why").value_or(""));
  return effects;
}

std::map<ErrorKey, MeasuredError> errors_of(const Json& components) {
  std::map<ErrorKey, MeasuredError> errors;
  for (const auto& [component, domains] : components.items())
    for (const auto& [domain, metrics] : domains.items())
      for (const auto& [metric, entry] : metrics.items())
        if (const auto error = error_of(entry))
          errors.emplace(ErrorKey{known_name(all_domains, domain), known_name(all_components, component), metric}, *error);
  return errors;
}

/// What the record says of the two parts of its errors.
void read_split(const Json& result, StudyRun& run) {
  run.light_paths = text_at(result, "light_paths").value_or("");
  const Json& split = object_at(result, "error_split");
  if (const auto complete = split.find("complete"); complete != split.end() && complete->is_boolean())
    run.complete = complete->get<bool>();
  run.model_errors = errors_of(object_at(split, "model"));
  run.discretisation_errors = errors_of(object_at(split, "discretisation"));
  const Json bounces = result.value("errors_per_bounce", Json::array());
  if (!bounces.is_array()) return;
  for (const Json& entry : bounces)
    run.bounces.push_back({static_cast<int>(number_at(entry, "bounce").value_or(0.0)), entry.value("complete", false),
                           errors_of(object_at(entry, "model")), errors_of(object_at(entry, "discretisation"))});
}

StudyRun completed(const Json& result, const StudyRun& before) {
  StudyRun run = before;
  if (const Json& parameters = object_at(result, "parameters"); !parameters.empty()) run.parameters = facts_of(parameters);
  run.seed = count_at(result, "seed");
  run.threads = count_at(result, "threads");
  if (const Json& effects = object_at(result, "effects"); !effects.empty()) run.effects = effects_of(effects);
  for (const auto& [stage, value] : object_at(result, "seconds").items())
    if (value.is_number()) run.seconds.emplace(stage, value.get<double>());
  const Json& memory = object_at(result, "memory");
  run.method_bytes = count_at(memory, "method_bytes");
  if (!run.peak_bytes) run.peak_bytes = count_at(memory, "peak_bytes");
  for (const auto& [name, value] : object_at(result, "counters").items())
    if (value.is_number_unsigned()) run.counters.emplace(name, value.get<std::uint64_t>());
  run.warnings = texts_at(result, "warnings");
  run.termination = text_at(result, "termination").value_or("");
  run.errors = errors_of(object_at(result, "errors"));
  read_split(result, run);
  run.details = facts_of(result, {"gibench_result", "scene", "method", "parameters", "seed", "threads", "version", "commit",
                                  "machine", "effects", "seconds", "memory", "counters", "warnings", "termination", "stages",
                                  "errors", "error_split", "errors_per_bounce"});
  return run;
}

}  // namespace

void read_result(const std::filesystem::path& file, StudyRun& run) {
  const Json result = read_json(file);
  if (!result.is_object()) throw InputError(file.string(), "is not a run record", "run the study again");
  try {
    run = completed(result, run);
  } catch (const nlohmann::json::exception&) {
    throw InputError(file.string(), "is not a run record", "run the study again");
  }
}

}  // namespace gibench::report
