#include "common/core/error.h"
#include "common/metrics/metric_table.h"
#include "reports/collect/collect.h"
#include "reports/collect/error_reading.h"
#include "reports/collect/json_reading.h"

namespace gibench::report {
namespace {

std::optional<BoundedNumber> bounded_at(const Json& object, const std::string& name) {
  const Json& entry = object_at(object, name);
  if (entry.empty()) return std::nullopt;
  BoundedNumber number{number_at(entry, "value"), {}, {}};
  const auto interval = entry.find("ci95");
  if (interval == entry.end() || !interval->is_array() || interval->size() != 2) return number;
  if ((*interval)[0].is_number()) number.low = (*interval)[0].get<double>();
  if ((*interval)[1].is_number()) number.high = (*interval)[1].get<double>();
  return number;
}

StudyRelight::Frame frame_of(const Json& entry) {
  StudyRelight::Frame frame;
  frame.at = number_at(entry, "at").value_or(0.0);
  frame.switched = texts_at(entry, "switched");
  const Json& seconds = object_at(entry, "seconds");
  frame.relight_seconds = number_at(seconds, "relight");
  frame.shade_seconds = number_at(seconds, "shade");
  for (const auto& [component, metrics] : object_at(entry, "errors").items())
    if (const auto error = error_of(object_at(metrics, headline_metric)))
      frame.relative_rmse.emplace(known_name(all_components, component), *error);
  return frame;
}

}  // namespace

void read_relight(const std::filesystem::path& file, StudyRelight& relight) {
  const Json record = read_json(file);
  const auto frames = record.find("frames");
  if (!record.is_object() || frames == record.end() || !frames->is_array())
    throw InputError(file.string(), "is no record of a relighting", "run the study again");
  const Json& summary = object_at(record, "summary");
  const Json& median = object_at(summary, "median_seconds");
  relight.frames = count_at(summary, "frames");
  relight.prepare_seconds = number_at(summary, "prepare_seconds");
  relight.relight_seconds = number_at(median, "relight");
  relight.shade_seconds = number_at(median, "shade");
  relight.path_tracing_seconds = bounded_at(summary, "path_tracing_seconds_at_equal_error");
  relight.times_cheaper = bounded_at(summary, "path_tracing_over_frame");
  relight.frames_that_pay = bounded_at(summary, "frames_that_pay_for_prepare");
  for (const Json& entry : *frames) relight.all_frames.push_back(frame_of(entry));
}

}  // namespace gibench::report
