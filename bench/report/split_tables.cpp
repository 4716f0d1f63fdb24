/// Tables of what scenes call for, and of what methods lack.
#include <algorithm>
#include <optional>

#include "bench/report/format.h"
#include "bench/report/study_tables.h"
#include "bench/report/table_cells.h"

namespace gibench::report {
namespace {

Cell error_cell(const Metric& metric, const MeasuredError* error) {
  return error ? Cell{error_text(metric, *error), exact(error->value)} : Cell{std::string(dash), ""};
}

Cell floor_cell(const Metric& metric, const MeasuredError* error) {
  return cell(
      error ? error->noise_floor : std::nullopt, [&](double floor) { return error_value(metric, floor); }, exact);
}

/// A run of all light paths has no model error: that is known, not measured.
Cell model_cell(const Metric& metric, bool complete, const MeasuredError* error) {
  return complete ? Cell{"none: all light paths", "0"} : error_cell(metric, error);
}

std::string missing_of(const StudyRun& run) {
  std::string names;
  if (run.effects)
    for (const std::string& effect : run.effects->missing) names += (names.empty() ? "" : ", ") + effect;
  return names;
}

const MeasuredError* at_key(const std::map<ErrorKey, MeasuredError>& errors, const ErrorKey& key) {
  const auto found = errors.find(key);
  return found == errors.end() ? nullptr : &found->second;
}

}  // namespace

Table call_table(const Study& study) {
  Table table{.name = "scene-effects",
              .caption = "What each scene calls for, and how many reflections its light needs.",
              .columns = {{"Scene", "scene", false}},
              .rows = {}};
  for (const StudyScene& scene : study.scenes)
    for (const SceneEffect& effect : scene.effects)
      if (std::none_of(table.columns.begin(), table.columns.end(), [&](const Column& c) { return c.name == effect.effect; }))
        table.columns.push_back({effect.effect, effect.effect, false});
  table.columns.push_back({"Bounces", "bounces", false});
  for (const StudyScene& scene : study.scenes) {
    if (scene.effects.empty()) continue;
    std::vector<Cell> row(table.columns.size(), text_cell(""));
    row.front() = text_cell(scene.name);
    row.back() = text_cell(scene.bounces);
    for (const SceneEffect& effect : scene.effects)
      for (std::size_t c = 1; c < table.columns.size(); ++c)
        if (table.columns[c].name == effect.effect) row[c] = text_cell(effect.called_for ? "called for" : "not called for");
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table evidence_table(const Study& study) {
  Table table{.name = "scene-evidence",
              .caption = "Why each scene calls for an effect or not.",
              .columns = {{"Scene", "scene", false},
                          {"Effect", "effect", false},
                          {"Verdict", "verdict", false},
                          {"Evidence", "evidence", false}},
              .rows = {}};
  for (const StudyScene& scene : study.scenes) {
    for (const SceneEffect& effect : scene.effects)
      table.rows.push_back({text_cell(scene.name), text_cell(effect.effect),
                            text_cell(effect.called_for ? "called for" : "not called for"), text_cell(effect.evidence)});
    if (!scene.bounces.empty())
      table.rows.push_back(
          {text_cell(scene.name), text_cell("bounces"), text_cell(scene.bounces), text_cell(scene.bounce_bound)});
  }
  return table;
}

Table split_table(const Study& study, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Table table{.name = "error-split",
              .caption = metric.title + " of " + describe(key) +
                         " in two parts. Model error: the reference of the light paths that the method simulates against that of "
                         "all. Discretisation error: the method against the former. In brackets the 95% interval.",
              .columns = {{"Scene", "scene", false},
                          {"Run", "run", false},
                          {"Method", "method", false},
                          {"Missing", "missing", false},
                          {"Model error", "model_error"},
                          {"Noise floor", "model_noise_floor"},
                          {"Discretisation error", "discretisation_error"},
                          {"Noise floor", "discretisation_noise_floor"},
                          {"Total error", "total_error"},
                          {"Light paths", "light_paths", false}},
              .rows = {}};
  for (const StudyRun& run : study.runs) {
    if (run.status != RunStatus::done || !run.complete || !run.error(key)) continue;
    const MeasuredError *model = run.model_error(key), *own = run.discretisation_error(key);
    table.rows.push_back({text_cell(run.scene), text_cell(run.label), text_cell(run.method), text_cell(missing_of(run)),
                          model_cell(metric, *run.complete, model), floor_cell(metric, model), error_cell(metric, own),
                          floor_cell(metric, own), error_cell(metric, run.error(key)), text_cell(run.light_paths)});
  }
  return table;
}

Table bounce_table(const Study& study, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Table table{.name = "error-per-bounce",
              .caption = metric.title + " of the light of each number of reflections by itself, " + describe(key) + ".",
              .columns = {{"Scene", "scene", false},
                          {"Run", "run", false},
                          {"Bounce", "bounce"},
                          {"Model error", "model_error"},
                          {"Noise floor", "model_noise_floor"},
                          {"Discretisation error", "discretisation_error"},
                          {"Noise floor", "discretisation_noise_floor"}},
              .rows = {}};
  for (const StudyRun& run : study.runs)
    for (const StudyRun::Bounce& bounce : run.bounces) {
      const MeasuredError *model = at_key(bounce.model_errors, key), *own = at_key(bounce.discretisation_errors, key);
      if (!own) continue;
      table.rows.push_back({text_cell(run.scene), text_cell(run.label), text_cell(std::to_string(bounce.number)),
                            model_cell(metric, bounce.complete, model), floor_cell(metric, model), error_cell(metric, own),
                            floor_cell(metric, own)});
    }
  return table;
}

}  // namespace gibench::report
