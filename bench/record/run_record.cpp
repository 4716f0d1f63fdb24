#include "bench/record/run_record.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/record/json_fields.h"

namespace gibench {

namespace {

constexpr const char* covered_seed = "method_seed";

Json counters_of(const Counters& counters) {
  Json json = Json::object();
  for (const auto& [name, value] : counters.values()) json[name] = value;
  return json;
}

Json stages_of(const std::vector<StageRecord>& stages) {
  Json list = Json::array();
  for (const auto& [stage, report] : stages) {
    Json entry{{"stage", to_string(stage)}, {"termination", to_string(report.termination)}, {"seconds", report.seconds}};
    if (!report.message.empty()) entry["message"] = report.message;
    entry["counters"] = counters_of(report.counters);
    list.push_back(std::move(entry));
  }
  return list;
}

Json measured_at_json(const MeasuredAt& at) {
  Json json{{"surface_samples", at.surface_samples}};
  if (!at.surface_domain.empty()) json["surface_domain"] = at.surface_domain;
  write_field(json, "sealed_share", at.sealed_share);
  json["reference_seed"] = at.reference_seed;
  if (!at.camera) return json;
  write_camera(json, *at.camera);
  json["pixel_samples"] = at.pixel_samples;
  return json;
}

Json errors_of(const ComponentErrors& errors) {
  Json json = Json::object();
  for (const auto& [component, domains] : errors)
    for (const auto& [domain, table] : domains) json[to_string(component)][to_string(domain)] = to_json(table);
  return json;
}

Json split_of(const RunRecord& record) {
  if (record.complete)
    return {{"complete", true}, {"why", "every light path of the scene is simulated: there is no model error"}};
  Json json{{"complete", false}};
  if (!record.split) return json;
  json["model"] = errors_of(record.split->model);
  json["discretisation"] = errors_of(record.split->discretisation);
  json["reference"] = to_json(record.split->reference);
  return json;
}

Json bounces_of(const std::vector<BounceErrors>& bounces) {
  Json list = Json::array();
  for (const BounceErrors& one : bounces) {
    Json entry{{"bounce", one.bounce}, {"complete", !one.model.has_value()}};
    if (one.model) entry["model"] = errors_of(*one.model);
    entry["discretisation"] = errors_of(one.discretisation);
    list.push_back(std::move(entry));
  }
  return list;
}

Json completed_by(const std::vector<Component>& components) {
  Json names = Json::array();
  for (const Component component : components) names.push_back(to_string(component));
  return {{"components", std::move(names)}, {"by", "shared direct-light evaluator"}};
}

Json memory_of(const RunRecord& record) {
  Json memory = Json::object();
  if (record.method_bytes > 0) memory["method_bytes"] = record.method_bytes;
  if (record.peak_bytes > 0) memory["peak_bytes"] = record.peak_bytes;
  return memory;
}

Json seconds_json(const RunRecord& record) {
  Json json = Json::object();
  for (const auto& [stage, seconds] : seconds_of(record)) json[to_string(stage)] = seconds;
  return json;
}

}  // namespace

Json to_json(const ErrorTable& table) {
  Json metrics = Json::object();
  for (const auto& [name, error] : table) {
    if (!std::isfinite(error.value)) continue;  // psnr of equal pictures: JSON has no infinity
    Json entry{{"value", error.value}};
    if (std::isfinite(error.low) && std::isfinite(error.high)) entry["ci95"] = {error.low, error.high};
    if (error.noise_floor) entry["noise_floor"] = *error.noise_floor;
    entry["resolved"] = error.resolved;
    write_field(entry, "seed_deviation", error.seed_deviation);
    metrics[name] = std::move(entry);
  }
  return metrics;
}

Json to_json(const ParameterValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json to_json(const ParameterValues& values) {
  Json json = Json::object();
  for (const auto& [name, value] : values) json[name] = to_json(value);
  return json;
}

std::vector<std::string> covered_by_intervals(const RunRecord& record) {
  std::vector<std::string> covered{"reference", "points"};
  if (!record.method_seeds.empty() || record.noise_of_points) covered.emplace_back(covered_seed);
  return covered;
}

Termination termination_of(const RunRecord& record) {
  for (const StageRecord& stage : record.stages)
    if (stage.report.termination != Termination::done) return stage.report.termination;
  return Termination::done;
}

std::vector<std::pair<Stage, double>> seconds_of(const RunRecord& record) {
  std::vector<std::pair<Stage, double>> seconds{{Stage::load, record.load_seconds}};
  double shade = 0.0;
  bool shaded = false;
  for (const auto& [stage, report] : record.stages) {
    if (stage == Stage::shade_surface || stage == Stage::shade_image) shade += report.seconds, shaded = true;
    seconds.emplace_back(stage, report.seconds);
  }
  if (shaded) seconds.emplace_back(Stage::shade, shade);
  return seconds;
}

Json to_json(const RunRecord& record) {
  Json json{{"gibench_result", 1}, {"scene", record.scene}, {"method", record.method}};
  json["parameters"] = to_json(record.parameters);
  json["seed"] = record.seed;
  json["threads"] = record.threads;
  write_origin(json, record.origin);
  json["measured_at"] = measured_at_json(record.measured_at);
  json["effects"] = to_json(record.plan);
  json["light_paths"] = record.light_paths;
  if (!record.completed.empty()) json["completed_by"] = completed_by(record.completed);
  json["seconds"] = seconds_json(record);
  json["memory"] = memory_of(record);
  json["counters"] = counters_of(record.counters);
  json["warnings"] = record.warnings;
  json["termination"] = to_string(termination_of(record));
  json["stages"] = stages_of(record.stages);
  write_exposure(json, record.exposure);
  if (!record.errors.empty()) {
    json["intervals_cover"] = covered_by_intervals(record);
    if (!record.method_seeds.empty()) json["method_seeds"] = record.method_seeds;
    json["errors"] = errors_of(record.errors);
    json["error_split"] = split_of(record);
  }
  if (!record.per_bounce.empty()) json["errors_per_bounce"] = bounces_of(record.per_bounce);
  if (record.reference) json["reference"] = to_json(*record.reference);
  if (!record.files.empty()) json["files"] = to_json(record.files);
  return json;
}

namespace {

MeasuredAt measured_at_of(const Json& json) {
  MeasuredAt at;
  read_field(json, "surface_samples", at.surface_samples);
  read_field(json, "surface_domain", at.surface_domain);
  read_field(json, "sealed_share", at.sealed_share);
  read_field(json, "reference_seed", at.reference_seed);
  read_field(json, "pixel_samples", at.pixel_samples);
  at.camera = camera_in(json);
  return at;
}

Counters counters_in(const Json& json) {
  Counters counters;
  for (const auto& [name, value] : json.items()) counters.add(name, value.get<std::uint64_t>());
  return counters;
}

std::vector<StageRecord> stages_in(const Json& list) {
  std::vector<StageRecord> stages;
  for (const Json& entry : list) {
    StageRecord stage{known_name(all_stages, entry.at("stage").get<std::string>(), "stages"), {}};
    stage.report.termination = known_name(all_terminations, entry.at("termination").get<std::string>(), "termination");
    read_field(entry, "message", stage.report.message);
    read_field(entry, "seconds", stage.report.seconds);
    stage.report.counters = counters_in(object_field(entry, "counters"));
    stages.push_back(std::move(stage));
  }
  return stages;
}

/// An end of an interval; null where nothing bounds it.
double end_of(const Json& json, double unbounded) { return json.is_null() ? unbounded : json.get<double>(); }

ErrorValue error_value_of(const Json& json) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  ErrorValue error{json.at("value").get<double>(), -infinite, infinite, std::nullopt, true};
  if (const Json* interval = field(json, "ci95"))
    error.low = end_of(interval->at(0), -infinite), error.high = end_of(interval->at(1), infinite);
  read_field(json, "noise_floor", error.noise_floor);
  error.resolved = error.low > 0.0 || error.high < 0.0;  // older records do not say
  read_field(json, "resolved", error.resolved);
  read_field(json, "seed_deviation", error.seed_deviation);
  return error;
}

}  // namespace

ErrorTable error_table_of(const Json& json) {
  ErrorTable table;
  for (const auto& [metric, entry] : json.items()) table[metric] = error_value_of(entry);
  return table;
}

namespace {

ComponentErrors errors_in(const Json& components) {
  ComponentErrors errors;
  for (const auto& [component, domains] : components.items())
    for (const auto& [domain, metrics] : domains.items())
      errors[known_name(all_components, component, "errors")][known_name(all_domains, domain, "errors")] =
          error_table_of(metrics);
  return errors;
}

void read_split(const Json& json, RunRecord& record) {
  read_field(json, "complete", record.complete);
  if (const Json* model = field(json, "model"))
    record.split = ErrorSplit{errors_in(*model), errors_in(object_field(json, "discretisation")),
                              reference_facts_of(object_field(json, "reference"))};
}

std::vector<BounceErrors> bounces_in(const Json& list) {
  std::vector<BounceErrors> bounces;
  for (const Json& entry : list) {
    BounceErrors one{entry.at("bounce").get<int>(), std::nullopt, errors_in(object_field(entry, "discretisation"))};
    if (!entry.at("complete").get<bool>()) one.model = errors_in(object_field(entry, "model"));
    bounces.push_back(std::move(one));
  }
  return bounces;
}

}  // namespace

ParameterValues parameters_of(const Json& json) {
  ParameterValues values;
  for (const auto& [name, value] : json.items()) {
    if (value.is_boolean()) values[name] = value.get<bool>();
    else if (value.is_number_integer()) values[name] = value.get<std::int64_t>();
    else if (value.is_number()) values[name] = value.get<double>();
    else values[name] = value.get<std::string>();
  }
  return values;
}

RunRecord run_record_of(const Json& json) {
  if (json.at("gibench_result").get<int>() != 1) throw InputError("gibench_result", "is not 1");
  RunRecord record;
  read_field(json, "scene", record.scene);
  read_field(json, "method", record.method);
  record.parameters = parameters_of(object_field(json, "parameters"));
  read_field(json, "seed", record.seed);
  read_field(json, "threads", record.threads);
  record.origin = origin_of(json);
  record.measured_at = measured_at_of(object_field(json, "measured_at"));
  record.plan = effect_plan_of(object_field(json, "effects"));
  read_field(json, "light_paths", record.light_paths);
  std::vector<std::string> completed;
  read_field(object_field(json, "completed_by"), "components", completed);
  for (const std::string& component : completed)
    record.completed.push_back(known_name(all_components, component, "completed_by"));
  read_field(object_field(json, "seconds"), "load", record.load_seconds);
  record.stages = stages_in(object_field(json, "stages"));
  read_field(object_field(json, "memory"), "method_bytes", record.method_bytes);
  read_field(object_field(json, "memory"), "peak_bytes", record.peak_bytes);
  record.counters = counters_in(object_field(json, "counters"));
  read_field(json, "warnings", record.warnings);
  record.exposure = exposure_in(json);
  record.errors = errors_in(object_field(json, "errors"));
  read_field(json, "method_seeds", record.method_seeds);
  std::vector<std::string> covered;
  read_field(json, "intervals_cover", covered);
  record.noise_of_points =
      record.method_seeds.empty() && std::find(covered.begin(), covered.end(), covered_seed) != covered.end();
  record.files = file_checksums_of(object_field(json, "files"));
  read_split(object_field(json, "error_split"), record);
  record.per_bounce = bounces_in(object_field(json, "errors_per_bounce"));
  if (const Json* reference = field(json, "reference")) record.reference = reference_facts_of(*reference);
  return record;
}

RunRecord read_run_record(const std::filesystem::path& file) { return read_record(file, "a run record", run_record_of); }

}  // namespace gibench
