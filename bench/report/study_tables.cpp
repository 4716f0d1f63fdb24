#include "bench/report/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "bench/report/format.h"
#include "bench/report/table_cells.h"

namespace gibench::report {
namespace {

std::string speed_up_text(const SpeedUp& speed) {
  return fmt::format("{}{}{}", speed.at_least ? "≥ " : "", factor(speed.factor), speed.extrapolated ? " *" : "");
}

std::string shade_stage(const StudyRun& run, const std::string& domain) {
  return run.seconds.contains("shade_" + domain) ? "shade_" + domain : "shade";
}

std::vector<Cell> scene_row(const StudyRun& run, const BaselineCurve& curve, const ErrorKey& key, const Metric& metric) {
  const MeasuredError* error = run.error(key);
  const auto speed = speed_up(curve, run, key);
  return {text_cell(run.label),
          text_cell(run.method),
          text_cell(status_text(run.status)),
          {error ? error_text(metric, *error) : std::string(dash), error ? exact(error->value) : ""},
          cell(
              error ? error->noise_floor : std::nullopt, [&](double floor) { return error_value(metric, floor); }, exact),
          cell(speed, speed_up_text, [](const SpeedUp& s) { return exact(s.factor); }),
          seconds_cell(run.transport_seconds(key.domain)),
          seconds_cell(at(run.seconds, "prepare")),
          seconds_cell(at(run.seconds, "light")),
          seconds_cell(at(run.seconds, shade_stage(run, key.domain))),
          bytes_cell(run.method_bytes),
          bytes_cell(run.peak_bytes),
          count_cell(at(run.counters, "closest_hit_rays")),
          count_cell(at(run.counters, "occlusion_rays"))};
}

/// The speed-up on one scene, or how the run ended where it gave no answer.
Cell ranked_cell(const Study& study, const RankedRun& ranked) {
  if (ranked.speed_up) return {speed_up_text(*ranked.speed_up), exact(ranked.speed_up->factor)};
  const bool ended = ranked.run && study.runs[*ranked.run].status != RunStatus::done;
  return {ended ? status_text(study.runs[*ranked.run].status) : std::string(dash), ""};
}

}  // namespace

std::string scene_slug(const Study& study, std::size_t scene) {
  std::string slug;
  for (const char c : study.scenes[scene].name) {
    const bool keep = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    if (keep) slug += c;
    else if (!slug.empty() && slug.back() != '-') slug += '-';
  }
  while (slug.ends_with('-')) slug.pop_back();
  return fmt::format("scene-{}{}{}", scene + 1, slug.empty() ? "" : "-", slug.substr(0, 60));
}

Table scene_table(const Study& study, std::size_t scene, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Table table{.name = scene_slug(study, scene),
              .caption = study.scenes[scene].name + ": " + metric.title + " of " + describe(key) +
                         " with its 95% interval, speed-up over the path tracer at equal error (* beyond its measured errors), "
                         "seconds, memory and rays.",
              .columns = {{"Run", "run", false},
                          {"Method", "method", false},
                          {"Status", "status", false},
                          {metric.title + " [95% interval]", key.metric},
                          {"Noise floor", "noise_floor"},
                          {"Speed-up", "speed_up"},
                          {"Time", "seconds"},
                          {"Prepare", "prepare_seconds"},
                          {"Light", "light_seconds"},
                          {"Shade", "shade_seconds"},
                          {"Method memory", "method_bytes"},
                          {"Peak memory", "peak_bytes"},
                          {"Closest-hit rays", "closest_hit_rays"},
                          {"Occlusion rays", "occlusion_rays"}},
              .rows = {}};
  const BaselineCurve curve = baseline_curve(study, study.scenes[scene].name, key);
  for (const std::size_t run : study.runs_of(study.scenes[scene].name))
    table.rows.push_back(scene_row(study.runs[run], curve, key, metric));
  return table;
}

Table ranking_table(const Study& study, const ErrorKey& key, const std::vector<RankingRow>& rows) {
  const auto left_out = [](const StudyScene& scene) { return scene.skipped.has_value(); };
  const auto answered = std::count_if(study.scenes.begin(), study.scenes.end(), std::not_fn(left_out));
  const std::string of = fmt::format(" of {}", answered);
  Table table{.name = "ranking",
              .caption = "Speed-up over the path tracer at equal " + metric_info(key.metric).title + " of " + describe(key) +
                         ": the path tracer's time for a run's error over the run's time; geometric mean over the scenes.",
              .columns = {{"Run", "run", false},
                          {"Method", "method", false},
                          {"Geometric mean", "geometric_mean_speed_up"},
                          {"Scenes" + of, "scenes_compared"},
                          {"Mean error rank", "mean_error_rank"},
                          {"On the front" + of, "scenes_on_front"},
                          {"Without answer" + of, "scenes_without_answer"}},
              .rows = {}};
  for (const StudyScene& scene : study.scenes)
    if (!scene.skipped) table.columns.push_back({scene.name, scene.name});
  for (const RankingRow& row : rows) {
    std::vector<Cell> cells = {
        text_cell(row.label),
        text_cell(row.method),
        {row.geometric_mean ? std::string(row.at_least ? "≥ " : "").append(factor(*row.geometric_mean)) : std::string(dash),
         row.geometric_mean ? exact(*row.geometric_mean) : ""},
        text_cell(std::to_string(row.compared)),
        cell(
            row.mean_error_rank, [](double r) { return fmt::format("{:.1f}", r); }, exact),
        text_cell(std::to_string(row.on_front)),
        text_cell(std::to_string(row.not_done))};
    for (std::size_t scene = 0; scene < row.scenes.size(); ++scene)
      if (!study.scenes[scene].skipped) cells.push_back(ranked_cell(study, row.scenes[scene]));
    table.rows.push_back(std::move(cells));
  }
  return table;
}

Table error_table(const Study& study) {
  Table table{.name = "errors",
              .caption = "Every error of every run with its 95% interval and the reference's noise floor.",
              .columns = {{"Scene", "scene", false},
                          {"Run", "run", false},
                          {"Method", "method", false},
                          {"Domain", "domain", false},
                          {"Component", "component", false},
                          {"Metric", "metric", false},
                          {"Value", "value"},
                          {"Low", "ci95_low"},
                          {"High", "ci95_high"},
                          {"Noise floor", "noise_floor"},
                          {"Below the floor", "below_noise_floor", false},
                          {"Time", "seconds"}},
              .rows = {}};
  for (const StudyRun& run : study.runs)
    for (const auto& [key, error] : run.errors)
      table.rows.push_back({text_cell(run.scene), text_cell(run.label), text_cell(run.method), text_cell(key.domain),
                            text_cell(key.component), text_cell(key.metric), number_cell(error.value), number_cell(error.low),
                            number_cell(error.high), number_cell(error.noise_floor),
                            text_cell(error.below_noise_floor ? "yes" : "no"), seconds_cell(run.transport_seconds(key.domain))});
  return table;
}

}  // namespace gibench::report
