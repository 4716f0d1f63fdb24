#include "bench/record/run_record.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/record/machine.h"

namespace gibench {

namespace {

using Json = nlohmann::ordered_json;

Json name_list(const EffectSet& effects) {
  Json names = Json::array();
  for (const Effect effect : effects) names.push_back(to_string(effect));
  return names;
}

Json seconds_of(const RunRecord& record) {
  Json seconds{{"load", record.load_seconds}};
  double shade = 0.0;
  bool shaded = false;
  for (const auto& [stage, report] : record.stages) {
    if (stage.starts_with("shade_")) shade += report.seconds, shaded = true;
    seconds[stage] = report.seconds;
  }
  if (shaded) seconds["shade"] = shade;
  return seconds;
}

Json counters_of(const Counters& counters) {
  Json json = Json::object();
  for (const auto& [name, value] : counters.values()) json[name] = value;
  return json;
}

Json stages_of(const std::vector<StageRecord>& stages) {
  Json list = Json::array();
  for (const auto& [stage, report] : stages) {
    Json entry{{"stage", stage}, {"termination", to_string(report.termination)}, {"seconds", report.seconds}};
    if (!report.message.empty()) entry["message"] = report.message;
    entry["counters"] = counters_of(report.counters);
    list.push_back(std::move(entry));
  }
  return list;
}

/// How the run ended: by the first stage that says more than "done".
std::string termination_of(const std::vector<StageRecord>& stages) {
  for (const StageRecord& stage : stages)
    if (stage.report.termination != Termination::done) return to_string(stage.report.termination);
  return to_string(Termination::done);
}

Json measured_at(const ReferenceQuestion& question) {
  Json json{{"surface_samples", question.surface_samples}, {"reference_seed", question.seed}};
  if (!question.camera) return json;
  json["camera"] = question.camera->name;
  json["resolution"] = {question.camera->width, question.camera->height};
  json["pixel_samples"] = question.pixel_samples;
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
  if (const std::uint64_t peak = peak_bytes(); peak > 0) memory["peak_bytes"] = peak;
  return memory;
}

}  // namespace

Json to_json(const ErrorTable& table) {
  Json metrics = Json::object();
  for (const auto& [name, error] : table) {
    if (!std::isfinite(error.value)) continue;  // psnr of equal pictures: JSON has no infinity
    Json entry{{"value", error.value}};
    if (std::isfinite(error.low) && std::isfinite(error.high)) entry["ci95"] = {error.low, error.high};
    if (error.noise_floor) {
      entry["noise_floor"] = *error.noise_floor;
      entry["below_noise_floor"] = error.below_noise_floor;
    }
    metrics[name] = std::move(entry);
  }
  return metrics;
}

Json to_json(const EffectPlan& plan) {
  Json skipped = Json::array();
  for (const SkippedEffect& effect : plan.skipped) skipped.push_back({{"effect", to_string(effect.effect)}, {"why", effect.why}});
  Json json{{"called_for", name_list(plan.called_for)},
            {"simulated", name_list(plan.simulated)},
            {"missing", name_list(plan.missing)},
            {"skipped", std::move(skipped)}};
  if (plan.max_bounces) json["max_bounces"] = *plan.max_bounces;
  return json;
}

Json to_json(const ParameterValue& value) {
  return std::visit([](const auto& v) { return Json(v); }, value);
}

Json to_json(const Exposure& exposure) { return {{"value", exposure.value}, {"start", exposure.start}, {"stop", exposure.stop}}; }

Json to_json(const RunRecord& record) {
  Json json{{"gibench_result", 1}, {"scene", record.scene}, {"method", record.method}};
  json["parameters"] = Json::object();
  for (const auto& [name, value] : record.parameters) json["parameters"][name] = to_json(value);
  json["seed"] = record.seed;
  json["threads"] = record.threads;
  json["version"] = version();
  json["commit"] = commit();
  json["machine"] = machine_json();
  json["measured_at"] = measured_at(record.question);
  json["effects"] = to_json(record.plan);
  json["light_paths"] = record.light_paths;
  if (!record.completed.empty()) json["completed_by"] = completed_by(record.completed);
  json["seconds"] = seconds_of(record);
  json["memory"] = memory_of(record);
  json["counters"] = counters_of(record.counters);
  json["warnings"] = record.warnings;
  json["termination"] = termination_of(record.stages);
  json["stages"] = stages_of(record.stages);
  if (record.exposure) json["exposure"] = to_json(*record.exposure);
  if (!record.errors.empty()) {
    json["errors"] = errors_of(record.errors);
    json["error_split"] = split_of(record);
  }
  if (!record.per_bounce.empty()) json["errors_per_bounce"] = bounces_of(record.per_bounce);
  if (record.reference) json["reference"] = to_json(*record.reference);
  return json;
}

}  // namespace gibench
