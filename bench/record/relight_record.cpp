#include "bench/record/relight_record.h"

#include <cmath>
#include <limits>
#include <span>

#include "bench/record/json_fields.h"

namespace gibench {

namespace {

template <class Of>
double median_over(const std::vector<RelitFrame>& frames, const Of& of) {
  std::vector<double> values;
  for (const RelitFrame& frame : frames) values.push_back(of(frame));
  return median_of(std::span<const double>(values));
}

/// {"value", "ci95": [low, high]}: what is not known is absent, an end that nothing bounds is null.
Json bounded_json(const Bounded& number) {
  const auto or_null = [](const std::optional<double>& end) { return end ? Json(*end) : Json(); };
  Json object = Json::object();
  if (number.value) object["value"] = *number.value;
  object["ci95"] = {or_null(number.low), or_null(number.high)};
  return object;
}

Bounded bounded_of(const Json& object) {
  Bounded number;
  read_field(object, "value", number.value);
  const Json &low = object.at("ci95").at(0), &high = object.at("ci95").at(1);
  if (!low.is_null()) number.low = low.get<double>();
  if (!high.is_null()) number.high = high.get<double>();
  return number;
}

std::optional<Bounded> bounded_in(const Json& object, const char* name) {
  const Json* entry = field(object, name);
  return entry ? std::optional(bounded_of(*entry)) : std::nullopt;
}

constexpr const char* path_tracing_name = "path_tracing_seconds_at_equal_error";

Json frame_json(const RelitFrame& frame) {
  Json object{{"at", frame.at},
              {"switched", frame.switched},
              {"seconds", {{"relight", frame.relight_seconds}, {"shade", frame.shade_seconds}}},
              {"termination", to_string(frame.termination)}};
  for (const auto& [component, table] : frame.errors)
    for (const auto& [metric, error] : table) {
      if (!std::isfinite(error.value)) continue;
      Json& value = object["errors"][to_string(component)][metric] = {{"value", error.value}, {"ci95", {error.low, error.high}}};
      if (error.noise_floor) value["noise_floor"] = *error.noise_floor;
      value["resolved"] = error.resolved;
    }
  if (!frame.reference) return object;
  object["reference"] = {
      {"seconds", frame.reference->seconds}, {"rmse", frame.reference->rmse}, {"paths", frame.reference->paths}};
  object[path_tracing_name] = bounded_json(frame.path_tracing);
  return object;
}

RelitFrame frame_of(const Json& object) {
  RelitFrame frame;
  read_field(object, "at", frame.at);
  read_field(object, "switched", frame.switched);
  read_field(object_field(object, "seconds"), "relight", frame.relight_seconds);
  read_field(object_field(object, "seconds"), "shade", frame.shade_seconds);
  if (const Json* name = field(object, "termination"))
    frame.termination = known_name(all_terminations, name->get<std::string>(), "termination");
  for (const auto& [component, metrics] : object_field(object, "errors").items())
    frame.errors[known_name(all_components, component, "errors")] = error_table_of(metrics);
  if (const Json* reference = field(object, "reference")) {
    frame.reference.emplace();
    read_field(*reference, "seconds", frame.reference->seconds);
    read_field(*reference, "rmse", frame.reference->rmse);
    read_field(*reference, "paths", frame.reference->paths);
  }
  frame.path_tracing = bounded_in(object, path_tracing_name).value_or(Bounded{});
  return frame;
}

Json summary_json(const RelightSummary& summary) {
  Json object{{"frames", summary.frames},
              {"prepare_seconds", summary.prepare_seconds},
              {"median_seconds", {{"relight", summary.relight_seconds}, {"shade", summary.shade_seconds}}}};
  if (summary.path_tracing_seconds) object[path_tracing_name] = bounded_json(*summary.path_tracing_seconds);
  if (summary.times_cheaper) object["path_tracing_over_frame"] = bounded_json(*summary.times_cheaper);
  if (summary.frames_that_pay) object["frames_that_pay_for_prepare"] = bounded_json(*summary.frames_that_pay);
  return object;
}

RelightSummary summary_of(const Json& object) {
  RelightSummary summary;
  read_field(object, "frames", summary.frames);
  read_field(object, "prepare_seconds", summary.prepare_seconds);
  read_field(object_field(object, "median_seconds"), "relight", summary.relight_seconds);
  read_field(object_field(object, "median_seconds"), "shade", summary.shade_seconds);
  summary.path_tracing_seconds = bounded_in(object, path_tracing_name);
  summary.times_cheaper = bounded_in(object, "path_tracing_over_frame");
  summary.frames_that_pay = bounded_in(object, "frames_that_pay_for_prepare");
  return summary;
}

RelightRecord relight_record_of(const Json& object) {
  RelightRecord record;
  read_field(object, "scene", record.scene);
  read_field(object, "method", record.method);
  read_field(object, "seed", record.seed);
  record.parameters = parameters_of(object_field(object, "parameters"));
  for (const Json& frame : object.at("frames")) record.frames.push_back(frame_of(frame));
  record.summary = summary_of(object.at("summary"));
  return record;
}

}  // namespace

RelightSummary summarise(double prepare_seconds, const std::vector<RelitFrame>& frames) {
  RelightSummary summary;
  summary.frames = frames.size();
  summary.prepare_seconds = prepare_seconds;
  summary.relight_seconds = median_over(frames, [](const RelitFrame& f) { return f.relight_seconds; });
  summary.shade_seconds = median_over(frames, [](const RelitFrame& f) { return f.shade_seconds; });
  if (!frames.front().reference) return summary;
  const double frame = summary.relight_seconds + summary.shade_seconds;
  std::vector<Bounded> seconds;
  for (const RelitFrame& each : frames) seconds.push_back(each.path_tracing);
  const Bounded path_tracing = median_of(std::span<const Bounded>(seconds));
  summary.path_tracing_seconds = path_tracing;
  summary.times_cheaper = times_cheaper(path_tracing, frame);
  summary.frames_that_pay = frames_that_pay(prepare_seconds, frame, path_tracing);
  return summary;
}

Json to_json(const RelightRecord& record) {
  Json object{{"scene", record.scene}, {"method", record.method}, {"seed", record.seed}};
  if (!record.parameters.empty()) object["parameters"] = to_json(record.parameters);
  for (const RelitFrame& frame : record.frames) object["frames"].push_back(frame_json(frame));
  object["summary"] = summary_json(record.summary);
  return object;
}

RelightRecord read_relight_record(const std::filesystem::path& file) {
  return read_record(file, "a record of a relighting", relight_record_of);
}

}  // namespace gibench
