#include "reports/tables/study_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "reports/tables/format.h"
#include "reports/tables/standing.h"
#include "reports/tables/table_columns.h"

namespace gibench::report {
namespace {

/// "≥ 12.3× [10.1, 15.2] *": a lower bound, the interval, and the mark of what lies beyond the path tracer's measured errors.
std::string factor_text(double value, bool at_least, std::optional<double> low, std::optional<double> high, bool extrapolated) {
  std::string text = (at_least ? "≥ " : "") + factor(value);
  if (low && high) text += fmt::format(" [{}, {}]", significant(*low), significant(*high));
  return text + (extrapolated ? " *" : "");
}

std::string speed_up_text(const SpeedUp& speed) {
  return factor_text(speed.factor, speed.at_least, speed.low, speed.high, speed.extrapolated);
}

/// The columns of CSV alone that go with a speed-up; `of` gives a `std::optional<SpeedUp>`.
template <class Row, class Of>
void add_speed_up_ends(Columns<Row>& columns, const std::string& name, Of of) {
  using Speed = std::optional<SpeedUp>;
  columns.in_csv(name + "_ci95_low", of, [](const Speed& speed) { return number_cell(speed ? speed->low : std::nullopt); })
      .in_csv(name + "_ci95_high", of, [](const Speed& speed) { return number_cell(speed ? speed->high : std::nullopt); })
      .in_csv(name + "_is_lower_bound", of, [](const Speed& speed) { return yes_or_no(speed, &SpeedUp::at_least); })
      .in_csv(name + "_extrapolated", of, [](const Speed& speed) { return yes_or_no(speed, &SpeedUp::extrapolated); });
}

/// A run on the scene that a table is of.
struct SceneRow {
  const StudyRun& run;
  std::optional<SpeedUp> speed_up;
  std::optional<Standing> standing;  ///< beside the most accurate run; empty where they were not compared

  std::optional<Comparison> beside_best() const { return standing ? standing->beside_best : std::nullopt; }
};

struct ErrorRow {
  const StudyRun& run;
  const ErrorKey& key;
  const MeasuredError& error;
};

/// How the run stands beside the most accurate one; the columns of CSV hold the difference and its interval.
void add_standing(Columns<SceneRow>& columns, const Metric& metric) {
  const auto beside = [](const SceneRow& row) { return row.beside_best(); };
  using Beside = std::optional<Comparison>;
  columns
      .cells({"Beside the best", "beside_best"},
             [metric](const SceneRow& row) {
               const std::string text = row.standing ? standing_text(metric, *row.standing) : std::string(dash);
               const auto comparison = row.beside_best();
               return Cell{text, comparison ? exact(comparison->difference) : ""};
             })
      .in_csv("beside_best_ci95_low", beside,
              [](const Beside& found) { return number_cell(found ? std::optional(found->low) : std::nullopt); })
      .in_csv("beside_best_ci95_high", beside,
              [](const Beside& found) { return number_cell(found ? std::optional(found->high) : std::nullopt); })
      .in_csv("beside_best_told_apart", beside,
              [](const Beside& found) { return found ? flag_cell(found->told_apart()) : text_cell(""); });
}

/// " (surfaces: seen)": where the scene's surface samples lie, if its records say so.
std::string domain_phrase(const Study& study, const std::string& scene, const ErrorKey& key) {
  if (key.domain != Domain::surface) return {};
  for (const std::size_t run : study.runs_of(scene))
    if (const std::string& domain = study.runs[run].surface_domain; !domain.empty()) return " (surfaces: " + domain + ")";
  return {};
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
  const std::string& name = study.scenes[scene].name;
  const Metric metric = metric_info(key.metric);
  const auto stage = [](Stage of) { return [of](const SceneRow& row) { return row.run.seconds_of(of); }; };
  const auto counter = [](const std::string& of) { return [of](const SceneRow& row) { return at(row.run.counters, of); }; };
  Columns<SceneRow> columns;
  columns.text("Run", "run", [](const SceneRow& row) { return row.run.label; })
      .text("Method", "method", [](const SceneRow& row) { return row.run.method; })
      .text("Status", "status", [](const SceneRow& row) { return status_text(row.run.status); })
      .error(metric.title + " [95% interval]", key.metric, metric, [&](const SceneRow& row) { return row.run.error(key); })
      .cells({"Noise floor", "noise_floor"}, [&](const SceneRow& row) { return floor_cell(metric, row.run.error(key)); });
  const std::map<std::size_t, Standing> compared = standings(study, scene, key);
  if (!compared.empty()) add_standing(columns, metric);
  columns.cells({"Speed-up", "speed_up"}, [](const SceneRow& row) {
    return cell(row.speed_up, speed_up_text, [](const SpeedUp& speed) { return exact(speed.factor); });
  });
  add_speed_up_ends(columns, "speed_up", std::mem_fn(&SceneRow::speed_up));
  columns.seconds("Time", "seconds", [&](const SceneRow& row) { return row.run.transport_seconds(key.domain); })
      .seconds("Prepare", "prepare_seconds", stage(Stage::prepare))
      .seconds("Light", "light_seconds", stage(Stage::light))
      .seconds("Shade", "shade_seconds", [&](const SceneRow& row) { return row.run.shade_seconds(key.domain); })
      .bytes("Method memory", "method_bytes", [](const SceneRow& row) { return row.run.method_bytes; })
      .bytes("Peak memory", "peak_bytes", [](const SceneRow& row) { return row.run.peak_bytes; })
      .count("Closest-hit rays", "closest_hit_rays", counter("closest_hit_rays"))
      .count("Occlusion rays", "occlusion_rays", counter("occlusion_rays"));
  SpeedUps speed_ups(study, name, key);
  std::vector<SceneRow> rows;
  for (const std::size_t run : study.runs_of(name))
    rows.push_back({study.runs[run], speed_ups.of(study.runs[run]), at(compared, run)});
  return columns.table(
      scene_slug(study, scene),
      name + ": " + metric.title + " of " + describe(key) + domain_phrase(study, name, key) + " with its 95% interval" +
          (compared.empty()
               ? ""
               : ", how it differs from the smallest one where the 95% interval of the difference tells them apart") +
          ", speed-up over the path tracer at equal error (* beyond its measured errors, ≥ a lower bound), "
          "seconds, memory and rays.",
      rows);
}

Table ranking_table(const Study& study, const ErrorKey& key, const std::vector<RankingRow>& rows) {
  const auto left_out = [](const StudyScene& scene) { return scene.skipped.has_value(); };
  const auto answered = std::count_if(study.scenes.begin(), study.scenes.end(), std::not_fn(left_out));
  const std::string of = fmt::format(" of {}", answered);
  Columns<RankingRow> columns;
  columns.text("Run", "run", [](const RankingRow& row) { return row.label; })
      .text("Method", "method", [](const RankingRow& row) { return row.method; })
      .cells({"Geometric mean", "geometric_mean_speed_up"},
             [](const RankingRow& row) {
               const auto text = [&](double mean) {
                 return factor_text(mean, row.at_least, row.mean_low, row.mean_high, row.extrapolated);
               };
               return cell(row.geometric_mean, text, exact);
             })
      .in_csv("geometric_mean_ci95_low", std::mem_fn(&RankingRow::mean_low), number_cell)
      .in_csv("geometric_mean_ci95_high", std::mem_fn(&RankingRow::mean_high), number_cell)
      .in_csv("geometric_mean_is_lower_bound", std::mem_fn(&RankingRow::at_least), flag_cell)
      .in_csv("geometric_mean_extrapolated", std::mem_fn(&RankingRow::extrapolated), flag_cell)
      .whole("Scenes" + of, "scenes_compared", [](const RankingRow& row) { return row.compared; })
      .cells({"Mean error rank", "mean_error_rank"},
             [](const RankingRow& row) {
               return cell(
                   row.mean_error_rank, [](double mean) { return fmt::format("{:.1f}", mean); }, exact);
             })
      .whole("On the front" + of, "scenes_on_front", [](const RankingRow& row) { return row.on_front; })
      .whole("Without result" + of, "scenes_without_answer", [](const RankingRow& row) { return row.not_done; });
  for (std::size_t s = 0; s < study.scenes.size(); ++s)
    if (const StudyScene& scene = study.scenes[s]; !scene.skipped) {
      columns.cells({scene.name, scene.name}, [&study, s](const RankingRow& row) { return ranked_cell(study, row.scenes[s]); });
      add_speed_up_ends(columns, scene.name, [s](const RankingRow& row) { return row.scenes[s].speed_up; });
    }
  return columns.table(
      "ranking",
      "Speed-up over the path tracer at equal " + metric_info(key.metric).title + " of " + describe(key) +
          ": the path tracer's time for a run's error over the run's time, with what the 95% intervals leave room for (* "
          "beyond its measured errors, ≥ the run's error is not resolved); geometric mean over the scenes.",
      rows);
}

Table error_table(const Study& study) {
  Columns<ErrorRow> columns;
  columns.text("Scene", "scene", [](const ErrorRow& row) { return row.run.scene; })
      .text("Run", "run", [](const ErrorRow& row) { return row.run.label; })
      .text("Method", "method", [](const ErrorRow& row) { return row.run.method; })
      .text("Domain", "domain", [](const ErrorRow& row) { return to_string(row.key.domain); })
      .text("Component", "component", [](const ErrorRow& row) { return to_string(row.key.component); })
      .text("Metric", "metric", [](const ErrorRow& row) { return row.key.metric; })
      .rounded("Value", "value", [](const ErrorRow& row) { return row.error.value; })
      .rounded("Low", "ci95_low", [](const ErrorRow& row) { return row.error.low; })
      .rounded("High", "ci95_high", [](const ErrorRow& row) { return row.error.high; })
      .rounded("Noise floor", "noise_floor", [](const ErrorRow& row) { return row.error.noise_floor; })
      .text("Resolved", "resolved", [](const ErrorRow& row) { return row.error.resolved ? "yes" : "no"; })
      .seconds("Time", "seconds", [](const ErrorRow& row) { return row.run.transport_seconds(row.key.domain); });
  std::vector<ErrorRow> rows;
  for (const StudyRun& run : study.runs)
    for (const auto& [key, error] : run.errors) rows.push_back({run, key, error});
  return columns.table("errors", "Every error of every run with its 95% interval and the reference's noise floor.", rows);
}

}  // namespace gibench::report
