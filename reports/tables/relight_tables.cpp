#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/tables/format.h"
#include "reports/tables/study_tables.h"
#include "reports/tables/table_cells.h"

namespace gibench::report {
namespace {

/// "3.1 [2.5, 4.2]", or the one end that is known: "≥ 2.5".
template <class Format>
std::string bounded_text(const Bounded& number, Format format) {
  const auto text = [&](const std::optional<double>& end) { return end ? format(*end) : std::string("–"); };
  if (number.value) return fmt::format("{} [{}, {}]", text(number.value), text(number.low), text(number.high));
  if (number.low && number.high) return fmt::format("[{}, {}]", text(number.low), text(number.high));
  if (number.low) return "≥ " + format(*number.low);
  return number.high ? "≤ " + format(*number.high) : std::string("not known");
}

template <class Format>
Cell bounded_cell(const std::optional<Bounded>& number, Format format) {
  return cell(
      number, [&](const Bounded& n) { return bounded_text(n, format); },
      [](const Bounded& n) { return n.value ? exact(*n.value) : std::string(); });
}

std::string significant_of(double value) { return significant(value); }
std::string whole_text(double value) { return fmt::format("{:.0f}", value); }

Cell error_cell(const StudyRelight::Frame& frame, const std::string& component) {
  const auto found = frame.relative_rmse.find(component);
  if (found == frame.relative_rmse.end()) return {std::string(dash), ""};
  return {error_text(metric_info("relative_rmse"), found->second), exact(found->second.value)};
}

}  // namespace

Table relight_table(const Study& study) {
  Table table{.name = "relighting",
              .caption =
                  "Relighting: a frame's seconds (median) beside path tracing to the same error of the indirect light at the "
                  "same surface samples, with 95% intervals, and the frames after which preparing has paid for itself.",
              .columns = {{"Scene", "scene", false},
                          {"Relighting", "relighting", false},
                          {"Method", "method", false},
                          {"Status", "status", false},
                          {"Frames", "frames"},
                          {"Prepare", "prepare_seconds"},
                          {"Frame: light", "relight_seconds"},
                          {"Frame: shade", "shade_seconds"},
                          {"Path tracing", "path_tracing_seconds"},
                          {"Cheaper by", "times_cheaper"},
                          {"Pays after frames", "frames_that_pay"}},
              .rows = {}};
  for (const StudyRelight& relight : study.relights)
    table.rows.push_back({text_cell(relight.scene), text_cell(relight.label), text_cell(relight.method),
                          text_cell(status_text(relight.status)), count_cell(relight.frames),
                          seconds_cell(relight.prepare_seconds), seconds_cell(relight.relight_seconds),
                          seconds_cell(relight.shade_seconds), bounded_cell(relight.path_tracing_seconds, duration),
                          bounded_cell(relight.times_cheaper, factor), bounded_cell(relight.frames_that_pay, whole_text)});
  return table;
}

Table relit_frame_table(const Study& study) {
  Table table{.name = "relit-frames",
              .caption =
                  "Every relit frame: its time on the light path, materials that switched, seconds, and relative RMSE at the "
                  "surface samples.",
              .columns = {{"Scene", "scene", false},
                          {"Relighting", "relighting", false},
                          {"Method", "method", false},
                          {"At", "at"},
                          {"Switched", "switched", false},
                          {"Light", "relight_seconds"},
                          {"Shade", "shade_seconds"},
                          {"Direct light", "direct_relative_rmse"},
                          {"Indirect light", "indirect_relative_rmse"}},
              .rows = {}};
  for (const StudyRelight& relight : study.relights)
    for (const StudyRelight::Frame& frame : relight.all_frames)
      table.rows.push_back({text_cell(relight.scene), text_cell(relight.label), text_cell(relight.method), number_cell(frame.at),
                            text_cell(fmt::format("{}", fmt::join(frame.switched, ", "))), seconds_cell(frame.relight_seconds),
                            seconds_cell(frame.shade_seconds), error_cell(frame, "direct"), error_cell(frame, "indirect")});
  return table;
}

std::string relight_sentence(const StudyRelight& relight) {
  if (!relight.prepare_seconds || !relight.frame_seconds() || !relight.frames_that_pay || !relight.times_cheaper) return {};
  const Bounded &pays = *relight.frames_that_pay, &cheaper = *relight.times_cheaper;
  const std::string head = fmt::format("{} on {}: a frame takes {} after {} of preparing", relight.label, relight.scene,
                                       duration(*relight.frame_seconds()), duration(*relight.prepare_seconds));
  if (cheaper.high && *cheaper.high <= 1.0)
    return head + "; path tracing to the same error is no slower, so preparing never pays.";
  std::string worth = "; the reference's noise does not tell what path tracing to the same error takes";
  if (cheaper.value)
    worth = fmt::format("; path tracing to the same error takes {} times that", bounded_text(cheaper, significant_of));
  else if (cheaper.low)
    worth = fmt::format("; path tracing to the same error takes at least {} times that", significant_of(*cheaper.low));
  if (pays.value)
    return head + worth + fmt::format(". Preparing has paid for itself after {} frames.", bounded_text(pays, whole_text));
  if (pays.high)
    return head + worth + fmt::format(". Preparing has paid for itself after {} frames at most.", whole_text(*pays.high));
  return head + worth + ". When preparing has paid for itself is not known.";
}

}  // namespace gibench::report
