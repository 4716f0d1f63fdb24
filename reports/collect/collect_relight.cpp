#include "bench/record/relight_record.h"
#include "common/metrics/metric_table.h"
#include "reports/collect/collect.h"
#include "reports/collect/error_reading.h"

namespace gibench::report {
namespace {

StudyRelight::Frame frame_of(const RelitFrame& recorded) {
  StudyRelight::Frame frame{recorded.at, recorded.switched, recorded.relight_seconds, recorded.shade_seconds, {}};
  for (const auto& [component, metrics] : recorded.errors)
    if (const auto error = metrics.find(headline_metric); error != metrics.end())
      frame.relative_rmse.emplace(component, measured(error->second));
  return frame;
}

}  // namespace

void read_relight(const std::filesystem::path& file, StudyRelight& relight) {
  const RelightRecord record = read_relight_record(file);
  relight.frames = record.summary.frames;
  relight.prepare_seconds = record.summary.prepare_seconds;
  relight.relight_seconds = record.summary.relight_seconds;
  relight.shade_seconds = record.summary.shade_seconds;
  relight.path_tracing_seconds = record.summary.path_tracing_seconds;
  relight.times_cheaper = record.summary.times_cheaper;
  relight.frames_that_pay = record.summary.frames_that_pay;
  for (const RelitFrame& frame : record.frames) relight.all_frames.push_back(frame_of(frame));
}

}  // namespace gibench::report
