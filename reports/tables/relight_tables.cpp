#include <fmt/format.h>
#include <fmt/ranges.h>

#include <functional>

#include "reports/tables/format.h"
#include "reports/tables/study_tables.h"
#include "reports/tables/table_columns.h"

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

/// A number that may be known by its bounds alone; in CSV the ends of its interval have columns of their own.
template <class Of, class Format>
void add_bounded(Columns<StudyRelight>& columns, std::string title, const std::string& name, Of of, Format format) {
  columns.cells({std::move(title), name}, [of, format](const StudyRelight& relight) { return bounded_cell(of(relight), format); })
      .in_csv(name + "_ci95_low", of, [](const auto& number) { return number_cell(number ? number->low : std::nullopt); })
      .in_csv(name + "_ci95_high", of, [](const auto& number) { return number_cell(number ? number->high : std::nullopt); });
}

struct FrameRow {
  const StudyRelight& relight;
  const StudyRelight::Frame& frame;
};

}  // namespace

Table relight_table(const Study& study) {
  Columns<StudyRelight> columns;
  columns.text("Scene", "scene", std::mem_fn(&StudyRelight::scene))
      .text("Relighting", "relighting", std::mem_fn(&StudyRelight::label))
      .text("Method", "method", std::mem_fn(&StudyRelight::method))
      .text("Status", "status", [](const StudyRelight& relight) { return status_text(relight.status); })
      .count("Frames", "frames", std::mem_fn(&StudyRelight::frames))
      .seconds("Prepare", "prepare_seconds", std::mem_fn(&StudyRelight::prepare_seconds))
      .seconds("Frame: light", "relight_seconds", std::mem_fn(&StudyRelight::relight_seconds))
      .seconds("Frame: shade", "shade_seconds", std::mem_fn(&StudyRelight::shade_seconds));
  add_bounded(columns, "Path tracing", "path_tracing_seconds", std::mem_fn(&StudyRelight::path_tracing_seconds), duration);
  add_bounded(columns, "Cheaper by", "times_cheaper", std::mem_fn(&StudyRelight::times_cheaper), factor);
  add_bounded(columns, "Pays after frames", "frames_that_pay", std::mem_fn(&StudyRelight::frames_that_pay), whole_text);
  return columns.table(
      "relighting",
      "Relighting: a frame's seconds (median) beside path tracing to the same error of the indirect light at the "
      "same surface samples, with 95% intervals, and the frames after which preparation has paid for itself.",
      study.relights);
}

Table relit_frame_table(const Study& study) {
  const Metric metric = metric_info(headline_metric);
  const auto error_of = [](Component component) {
    return [component](const FrameRow& row) -> const MeasuredError* {
      const auto found = row.frame.relative_rmse.find(component);
      return found == row.frame.relative_rmse.end() ? nullptr : &found->second;
    };
  };
  Columns<FrameRow> columns;
  columns.text("Scene", "scene", [](const FrameRow& row) { return row.relight.scene; })
      .text("Relighting", "relighting", [](const FrameRow& row) { return row.relight.label; })
      .text("Method", "method", [](const FrameRow& row) { return row.relight.method; })
      .rounded("At", "at", [](const FrameRow& row) { return row.frame.at; })
      .text("Switched", "switched", [](const FrameRow& row) { return fmt::format("{}", fmt::join(row.frame.switched, ", ")); })
      .seconds("Light", "relight_seconds", [](const FrameRow& row) { return row.frame.relight_seconds; })
      .seconds("Shade", "shade_seconds", [](const FrameRow& row) { return row.frame.shade_seconds; })
      .error("Direct light", "direct_relative_rmse", metric, error_of(Component::direct))
      .error("Indirect light", "indirect_relative_rmse", metric, error_of(Component::indirect));
  std::vector<FrameRow> rows;
  for (const StudyRelight& relight : study.relights)
    for (const StudyRelight::Frame& frame : relight.all_frames) rows.push_back({relight, frame});
  return columns.table("relit-frames",
                       "Every relit frame: its time from 0 to 1, materials that switched, seconds, and relative RMSE at the "
                       "surface samples.",
                       rows);
}

std::string relight_sentence(const StudyRelight& relight) {
  if (!relight.prepare_seconds || !relight.frame_seconds() || !relight.frames_that_pay || !relight.times_cheaper) return {};
  const Bounded &pays = *relight.frames_that_pay, &cheaper = *relight.times_cheaper;
  const std::string head = fmt::format("{} on {}: a frame takes {} after {} of preparing", relight.label, relight.scene,
                                       duration(*relight.frame_seconds()), duration(*relight.prepare_seconds));
  if (cheaper.high && *cheaper.high <= 1.0)
    return head + "; path tracing to the same error is as fast or faster, so preparation never pays.";
  std::string worth = "; the reference is too noisy to say how long path tracing to the same error takes";
  if (cheaper.value)
    worth = fmt::format("; path tracing to the same error takes {} times that", bounded_text(cheaper, significant_of));
  else if (cheaper.low)
    worth = fmt::format("; path tracing to the same error takes at least {} times that", significant_of(*cheaper.low));
  if (pays.value)
    return head + worth + fmt::format(". Preparation has paid for itself after {} frames.", bounded_text(pays, whole_text));
  if (pays.high)
    return head + worth + fmt::format(". Preparation has paid for itself after {} frames at most.", whole_text(*pays.high));
  return head + worth + ". It is not known when preparation has paid for itself.";
}

}  // namespace gibench::report
