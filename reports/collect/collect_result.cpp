#include <fmt/format.h>

#include <cmath>

#include "bench/record/pair_record.h"
#include "bench/record/run_record.h"
#include "common/core/error.h"
#include "reports/collect/collect.h"
#include "reports/collect/error_reading.h"
#include "reports/collect/facts.h"

namespace gibench::report {

MeasuredError measured(const ErrorValue& recorded) {
  MeasuredError error{.value = recorded.value, .low = {}, .high = {}, .noise_floor = recorded.noise_floor};
  if (std::isfinite(recorded.low) && std::isfinite(recorded.high)) error.low = recorded.low, error.high = recorded.high;
  error.resolved = recorded.resolved;
  return error;
}

namespace {

std::map<ErrorKey, MeasuredError> errors_of(const ComponentErrors& components) {
  std::map<ErrorKey, MeasuredError> errors;
  for (const auto& [component, domains] : components)
    for (const auto& [domain, metrics] : domains)
      for (const auto& [metric, error] : metrics) errors.emplace(ErrorKey{domain, component, metric}, measured(error));
  return errors;
}

std::string machine_text(const Machine& machine) {
  return fmt::format("{}, {} cores, {}, {}", machine.cpu.empty() ? "unknown processor" : machine.cpu, machine.cores,
                     machine.compiler, machine.build);
}

/// The two parts of the errors.
void add_split(const RunRecord& record, StudyRun& run) {
  run.light_paths = record.light_paths;
  if (!record.errors.empty()) run.complete = record.complete;
  if (record.split) {
    run.model_errors = errors_of(record.split->model);
    run.discretisation_errors = errors_of(record.split->discretisation);
  }
  for (const BounceErrors& one : record.per_bounce)
    run.bounces.push_back({one.bounce, !one.model.has_value(), one.model ? errors_of(*one.model) : decltype(run.errors){},
                           errors_of(one.discretisation)});
}

}  // namespace

void read_result(const std::filesystem::path& file, StudyRun& run) {
  const RunRecord record = read_run_record(file);
  const Json written = to_json(record);
  if (!record.parameters.empty()) run.parameters = facts_of(to_json(record.parameters));
  run.machine = machine_text(record.origin.machine);
  run.surface_domain = record.measured_at.surface_domain;
  run.surface_samples = record.measured_at.surface_samples;
  run.seed = record.seed;
  run.threads = static_cast<std::uint64_t>(record.threads);
  run.effects = record.plan;
  for (const auto& [stage, seconds] : seconds_of(record)) run.seconds.emplace(stage, seconds);
  if (record.method_bytes > 0) run.method_bytes = record.method_bytes;
  if (!run.peak_bytes && record.peak_bytes > 0) run.peak_bytes = record.peak_bytes;
  for (const auto& [name, value] : record.counters.values()) run.counters.emplace(name, value);
  run.warnings = record.warnings;
  run.termination = termination_of(record);
  run.errors = errors_of(record.errors);
  if (const auto pairs = record.files.find(pair_file); pairs != record.files.end()) run.pair_checksum = pairs->second;
  add_split(record, run);
  run.details = facts_of(written, {"gibench_result", "scene",   "method",      "parameters",        "seed",
                                   "threads",        "version", "commit",      "machine",           "effects",
                                   "seconds",        "memory",  "counters",    "warnings",          "termination",
                                   "stages",         "errors",  "error_split", "errors_per_bounce", "files"});
}

}  // namespace gibench::report
