#include "bench/record/relight_record.h"

#include <cmath>
#include <nlohmann/json.hpp>
#include <span>

namespace gibench {

namespace {

using Json = nlohmann::ordered_json;

template <class Of>
double median_over(const std::vector<RelitFrame>& frames, const Of& of) {
  std::vector<double> values;
  for (const RelitFrame& frame : frames) values.push_back(of(frame));
  return median_of(std::span<const double>(values));
}

/// {"value", "ci95": [low, high]}: what is not known is absent, an end that nothing bounds is null.
Json bounded_json(const Bounded& number) {
  const auto or_null = [](const std::optional<double>& end) { return end ? Json(*end) : Json(); };
  Json json = Json::object();
  if (number.value) json["value"] = *number.value;
  json["ci95"] = {or_null(number.low), or_null(number.high)};
  return json;
}

}  // namespace

Json relit_frame_json(const RelitFrame& frame) {
  Json json{{"at", frame.at},
            {"switched", frame.switched},
            {"seconds", {{"relight", frame.relight_seconds}, {"shade", frame.shade_seconds}}},
            {"termination", to_string(frame.termination)}};
  for (const auto& [component, table] : frame.errors)
    for (const auto& [metric, error] : table) {
      if (!std::isfinite(error.value)) continue;
      Json& value = json["errors"][to_string(component)][metric] = {{"value", error.value}, {"ci95", {error.low, error.high}}};
      if (error.noise_floor) value["noise_floor"] = *error.noise_floor;
      value["below_noise_floor"] = error.below_noise_floor;
    }
  if (!frame.reference) return json;
  json["reference"] = {{"seconds", frame.reference->seconds}, {"rmse", frame.reference->rmse}, {"paths", frame.reference->paths}};
  json["path_tracing_seconds_at_equal_error"] = bounded_json(frame.path_tracing);
  return json;
}

Json relight_summary_json(double prepare_seconds, const std::vector<RelitFrame>& frames) {
  const double relight = median_over(frames, [](const RelitFrame& f) { return f.relight_seconds; });
  const double shade = median_over(frames, [](const RelitFrame& f) { return f.shade_seconds; });
  const double frame = relight + shade;
  Json json{{"frames", frames.size()},
            {"prepare_seconds", prepare_seconds},
            {"median_seconds", {{"relight", relight}, {"shade", shade}}}};
  if (!frames.front().reference) return json;
  std::vector<Bounded> seconds;
  for (const RelitFrame& each : frames) seconds.push_back(each.path_tracing);
  const Bounded path_tracing = median_of(std::span<const Bounded>(seconds));
  json["path_tracing_seconds_at_equal_error"] = bounded_json(path_tracing);
  json["path_tracing_over_frame"] = bounded_json(times_cheaper(path_tracing, frame));
  json["frames_that_pay_for_prepare"] = bounded_json(frames_that_pay(prepare_seconds, frame, path_tracing));
  return json;
}

}  // namespace gibench
