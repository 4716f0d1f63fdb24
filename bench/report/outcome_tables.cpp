#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "bench/report/format.h"
#include "bench/report/study_tables.h"
#include "bench/report/table_cells.h"

namespace gibench::report {
namespace {

std::string joined(const Facts& facts) {
  std::string text;
  for (const auto& [name, value] : facts) text += (text.empty() ? "" : " ") + name + "=" + value;
  return text;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

void add_effects(const StudyRun& run, std::set<std::vector<std::string>>& known, Table& table) {
  const auto add = [&](const std::string& effect, const std::string& outcome, const std::string& why) {
    if (!known.insert({run.scene, run.method, effect, outcome, why}).second) return;
    table.rows.push_back({text_cell(run.scene), text_cell(run.method), text_cell(effect), text_cell(outcome), text_cell(why)});
  };
  for (const std::string& effect : run.effects->called_for) {
    const bool simulated = contains(run.effects->simulated, effect);
    const bool lacking = contains(run.effects->missing, effect);
    if (simulated || lacking)
      add(effect, simulated ? "simulated" : "missing", simulated ? "" : "the scene calls for it, the method cannot do it");
  }
  for (const std::string& effect : run.effects->missing)
    if (!contains(run.effects->called_for, effect)) add(effect, "missing", "the method cannot do it");
  for (const auto& [effect, why] : run.effects->skipped) add(effect, "skipped", why);
}

}  // namespace

Table effect_table(const Study& study) {
  Table table{.name = "effects",
              .caption = "What each scene calls for and what each method made of it; what was not called for was not computed.",
              .columns = {{"Scene", "scene", false},
                          {"Method", "method", false},
                          {"Effect", "effect", false},
                          {"Outcome", "outcome", false},
                          {"Why", "why", false}},
              .rows = {}};
  std::set<std::vector<std::string>> known;
  for (const StudyRun& run : study.runs)
    if (run.effects) add_effects(run, known, table);
  return table;
}

namespace {

/// Outcomes by effect, in the order in which the record tells them.
std::map<std::string, std::string> outcomes_of(const Effects& effects) {
  std::map<std::string, std::string> outcomes;
  for (const std::string& effect : effects.simulated) outcomes[effect] = "simulated";
  for (const std::string& effect : effects.missing) outcomes[effect] = "missing";
  for (const auto& skipped : effects.skipped)
    outcomes[skipped.first] = contains(effects.called_for, skipped.first) ? "not allowed" : "skipped";
  return outcomes;
}

/// Runs of one scene and method under one plan.
struct PlannedRuns {
  const StudyRun* first;
  std::map<std::string, std::string> outcomes;
};

/// The model error of the picture, or of the surface samples where there is none.
Cell cost_cell(const StudyRun& run) {
  if (run.complete == true) return {"none", "0"};
  for (const char* domain : {"image", "surface"})
    if (const MeasuredError* error = run.model_error({domain, "total", headline_metric}))
      return {error_text(metric_info(headline_metric), *error), exact(error->value)};
  return text_cell("");
}

}  // namespace

Table effect_matrix(const Study& study) {
  Table table{
      .name = "effect-matrix",
      .caption =
          "Effects by scene and method: simulated, missing (called for, beyond the method) or skipped (not called for, or "
          "not allowed); and what the light paths that are not simulated cost: the relative RMSE of the picture's total "
          "light without them.",
      .columns = {{"Scene", "scene", false}, {"Method", "method", false}},
      .rows = {}};
  std::vector<PlannedRuns> plans;
  std::map<std::pair<std::string, std::string>, int> variants;
  std::map<std::string, std::size_t> column;
  for (const StudyRun& run : study.runs) {
    if (!run.effects) continue;
    const auto outcomes = outcomes_of(*run.effects);
    const auto same = [&](const PlannedRuns& p) {
      return p.first->scene == run.scene && p.first->method == run.method && p.outcomes == outcomes &&
             p.first->light_paths == run.light_paths;
    };
    if (std::any_of(plans.begin(), plans.end(), same)) continue;
    plans.push_back({&run, outcomes});
    ++variants[{run.scene, run.method}];
    for (const auto& outcome : outcomes) column.try_emplace(outcome.first, 0);
  }
  std::vector<std::string> order;
  for (const StudyRun& run : study.runs)
    if (run.effects)
      for (const auto* names : {&run.effects->called_for})
        for (const std::string& name : *names)
          if (!contains(order, name)) order.push_back(name);
  for (const auto& entry : column)
    if (!contains(order, entry.first)) order.push_back(entry.first);
  for (const std::string& effect : order) {
    column[effect] = table.columns.size();
    table.columns.push_back({effect, effect, false});
  }
  table.columns.push_back({"Model error", "model_error", true});
  for (const PlannedRuns& plan : plans) {
    const StudyRun& run = *plan.first;
    const bool several = variants.at({run.scene, run.method}) > 1;
    std::vector<Cell> row(table.columns.size(), text_cell(""));
    row[0] = text_cell(run.scene);
    row[1] = text_cell(several ? run.label : run.method);
    for (const auto& [effect, outcome] : plan.outcomes) row[column.at(effect)] = text_cell(outcome);
    row.back() = cost_cell(run);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table failure_table(const Study& study) {
  Table table{.name = "failures",
              .caption = "Scenes that were left out, and runs that were refused, timed out, crashed or failed: results too.",
              .columns = {{"Scene", "scene", false},
                          {"Run", "run", false},
                          {"Method", "method", false},
                          {"Status", "status", false},
                          {"Exit status", "exit_status"},
                          {"After", "seconds"},
                          {"Why", "why", false}},
              .rows = {}};
  const Cell nothing{std::string(dash), ""};
  for (const StudyScene& scene : study.scenes)
    if (scene.skipped)
      table.rows.push_back(
          {text_cell(scene.name), nothing, nothing, text_cell("skipped"), nothing, nothing, text_cell(*scene.skipped)});
  for (const StudyRun& run : study.runs) {
    const auto in_skipped_scene = [&run](const StudyScene& scene) { return scene.skipped && scene.name == run.scene; };
    if (run.status == RunStatus::done || std::any_of(study.scenes.begin(), study.scenes.end(), in_skipped_scene)) continue;
    table.rows.push_back({text_cell(run.scene), text_cell(run.label), text_cell(run.method), text_cell(status_text(run.status)),
                          text_cell(run.exit_code ? std::to_string(*run.exit_code) : ""), seconds_cell(run.wall_seconds),
                          text_cell(run.message)});
  }
  return table;
}

Table run_table(const Study& study) {
  const std::vector<std::string> stages = {"load", "prepare", "light", "shade", "shade_surface", "shade_image"};
  const std::vector<std::string> counters = {"closest_hit_rays", "occlusion_rays"};
  Table table{.name = "runs",
              .caption = "Every run: parameters, seconds per stage, memory and rays.",
              .columns = {{"Scene", "scene", false},
                          {"Run", "run", false},
                          {"Method", "method", false},
                          {"Status", "status", false},
                          {"Parameters", "parameters", false},
                          {"Seed", "seed"},
                          {"Threads", "threads"}},
              .rows = {}};
  for (const std::string& stage : stages) table.columns.push_back({stage, stage + "_seconds"});
  table.columns.insert(table.columns.end(),
                       {{"Wall clock", "wall_seconds"}, {"Method memory", "method_bytes"}, {"Peak memory", "peak_bytes"}});
  for (const std::string& counter : counters) table.columns.push_back({counter, counter});
  const auto whole = [](std::optional<std::uint64_t> value) { return text_cell(value ? std::to_string(*value) : ""); };
  for (const StudyRun& run : study.runs) {
    std::vector<Cell> row = {text_cell(run.scene),
                             text_cell(run.label),
                             text_cell(run.method),
                             text_cell(status_text(run.status)),
                             text_cell(joined(run.parameters)),
                             whole(run.seed),
                             whole(run.threads)};
    for (const std::string& stage : stages) row.push_back(seconds_cell(at(run.seconds, stage)));
    row.insert(row.end(), {seconds_cell(run.wall_seconds), bytes_cell(run.method_bytes), bytes_cell(run.peak_bytes)});
    for (const std::string& counter : counters) row.push_back(count_cell(at(run.counters, counter)));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace gibench::report
