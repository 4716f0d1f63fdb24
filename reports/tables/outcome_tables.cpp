#include <algorithm>
#include <compare>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "reports/tables/format.h"
#include "reports/tables/study_tables.h"
#include "reports/tables/table_columns.h"

namespace gibench::report {
namespace {

std::string joined(const Facts& facts) {
  std::string text;
  for (const auto& [name, value] : facts) text += (text.empty() ? "" : " ") + name + "=" + value;
  return text;
}

enum class EffectOutcome { simulated, missing, skipped, not_allowed };

const char* to_string(EffectOutcome outcome) {
  switch (outcome) {
    case EffectOutcome::simulated: return "simulated";
    case EffectOutcome::missing: return "missing";
    case EffectOutcome::skipped: return "skipped";
    case EffectOutcome::not_allowed: break;
  }
  return "not allowed";
}

/// What a method made of an effect on a scene, and why.
struct EffectRow {
  std::string scene, method;
  Effect effect;
  EffectOutcome outcome;
  std::string why;
  auto operator<=>(const EffectRow&) const = default;
};

void add_effects(const StudyRun& run, std::set<EffectRow>& known, std::vector<EffectRow>& rows) {
  const auto add = [&](Effect effect, EffectOutcome outcome, const std::string& why) {
    const EffectRow row{run.scene, run.method, effect, outcome, why};
    if (known.insert(row).second) rows.push_back(row);
  };
  const EffectPlan& plan = *run.effects;
  for (const Effect effect : plan.called_for) {
    if (plan.simulates(effect)) add(effect, EffectOutcome::simulated, "");
    else if (plan.missing.contains(effect))
      add(effect, EffectOutcome::missing, "the scene calls for it, the method cannot do it");
  }
  for (const Effect effect : plan.missing)
    if (!plan.called_for.contains(effect)) add(effect, EffectOutcome::missing, "the method cannot do it");
  for (const SkippedEffect& skipped : plan.skipped) add(skipped.effect, EffectOutcome::skipped, skipped.why);
}

}  // namespace

Table effect_table(const Study& study) {
  Columns<EffectRow> columns;
  columns.text("Scene", "scene", std::mem_fn(&EffectRow::scene))
      .text("Method", "method", std::mem_fn(&EffectRow::method))
      .text("Effect", "effect", [](const EffectRow& row) { return to_string(row.effect); })
      .text("Outcome", "outcome", [](const EffectRow& row) { return to_string(row.outcome); })
      .text("Why", "why", std::mem_fn(&EffectRow::why));
  std::set<EffectRow> known;
  std::vector<EffectRow> rows;
  for (const StudyRun& run : study.runs)
    if (run.effects) add_effects(run, known, rows);
  return columns.table("effects", "Effects that scenes call for and methods simulated; what was not called for was not computed.",
                       rows);
}

namespace {

using EffectOutcomes = std::map<Effect, EffectOutcome>;

EffectOutcomes outcomes_of(const EffectPlan& plan) {
  EffectOutcomes outcomes;
  for (const Effect effect : plan.simulated) outcomes[effect] = EffectOutcome::simulated;
  for (const Effect effect : plan.missing) outcomes[effect] = EffectOutcome::missing;
  for (const SkippedEffect& skipped : plan.skipped)
    outcomes[skipped.effect] = plan.called_for.contains(skipped.effect) ? EffectOutcome::not_allowed : EffectOutcome::skipped;
  return outcomes;
}

/// Runs of one scene and method under one plan.
struct PlannedRuns {
  const StudyRun& first;
  EffectOutcomes outcomes;
};

std::vector<PlannedRuns> planned_runs(const Study& study) {
  std::vector<PlannedRuns> plans;
  for (const StudyRun& run : study.runs) {
    if (!run.effects) continue;
    PlannedRuns plan{run, outcomes_of(*run.effects)};
    const auto same = [&](const PlannedRuns& other) {
      return other.first.scene == run.scene && other.first.method == run.method && other.outcomes == plan.outcomes &&
             other.first.light_paths == run.light_paths;
    };
    if (std::none_of(plans.begin(), plans.end(), same)) plans.push_back(std::move(plan));
  }
  return plans;
}

/// First the effects that scenes call for, in the order of the records, then the others by name.
std::vector<Effect> effects_in_order(const Study& study, const std::vector<PlannedRuns>& plans) {
  std::vector<Effect> order;
  const auto add = [&order](Effect effect) {
    if (std::ranges::find(order, effect) == order.end()) order.push_back(effect);
  };
  for (const StudyRun& run : study.runs)
    if (run.effects) std::ranges::for_each(run.effects->called_for, add);
  std::map<std::string, Effect> others;
  for (const PlannedRuns& plan : plans)
    for (const auto& outcome : plan.outcomes) others.emplace(to_string(outcome.first), outcome.first);
  for (const auto& other : others) add(other.second);
  return order;
}

/// The model error of the picture, or of the surface samples where there is none.
const MeasuredError* cost_of(const StudyRun& run) {
  for (const Domain domain : all_domains)
    if (const MeasuredError* error = run.model_error({domain, Component::total, headline_metric})) return error;
  return nullptr;
}

Cell cost_cell(const StudyRun& run) {
  return run.complete == true ? Cell{"none", "0"} : error_cell(metric_info(headline_metric), cost_of(run));
}

}  // namespace

Table effect_matrix(const Study& study) {
  const std::vector<PlannedRuns> plans = planned_runs(study);
  std::map<std::pair<std::string, std::string>, int> variants;
  for (const PlannedRuns& plan : plans) ++variants[{plan.first.scene, plan.first.method}];
  Columns<PlannedRuns> columns;
  columns.text("Scene", "scene", [](const PlannedRuns& plan) { return plan.first.scene; })
      .text("Method", "method", [&](const PlannedRuns& plan) {
        const bool several = variants.at({plan.first.scene, plan.first.method}) > 1;
        return several ? plan.first.label : plan.first.method;
      });
  for (const Effect effect : effects_in_order(study, plans))
    columns.text(to_string(effect), to_string(effect), [effect](const PlannedRuns& plan) {
      const auto outcome = plan.outcomes.find(effect);
      return outcome == plan.outcomes.end() ? "" : to_string(outcome->second);
    });
  columns.cells({"Model error", "model_error"}, [](const PlannedRuns& plan) { return cost_cell(plan.first); })
      .error_ends("model_error", [](const PlannedRuns& plan) { return cost_of(plan.first); });
  return columns.table(
      "effect-matrix",
      "Effects by scene and method: simulated, missing (called for, beyond the method) or skipped (not called for, or "
      "not allowed); and what the light paths that are not simulated cost: the relative RMSE of the picture's total "
      "light without them.",
      plans);
}

namespace {

/// A scene that was left out, or a run that gave no answer.
struct Failure {
  std::string scene, run, method, status;
  std::optional<int> exit_code;
  std::optional<double> seconds;
  std::string why;
};

std::vector<Failure> failures_of(const Study& study) {
  std::vector<Failure> failures;
  for (const StudyScene& scene : study.scenes)
    if (scene.skipped) failures.push_back({scene.name, "", "", "skipped", {}, {}, *scene.skipped});
  for (const StudyRun& run : study.runs) {
    const auto in_skipped_scene = [&run](const StudyScene& scene) { return scene.skipped && scene.name == run.scene; };
    if (run.status == RunStatus::done || std::any_of(study.scenes.begin(), study.scenes.end(), in_skipped_scene)) continue;
    failures.push_back({run.scene, run.label, run.method, status_text(run.status), run.exit_code, run.wall_seconds, run.message});
  }
  return failures;
}

}  // namespace

Table failure_table(const Study& study) {
  Columns<Failure> columns;
  columns.text("Scene", "scene", std::mem_fn(&Failure::scene))
      .text("Run", "run", std::mem_fn(&Failure::run))
      .text("Method", "method", std::mem_fn(&Failure::method))
      .text("Status", "status", std::mem_fn(&Failure::status))
      .whole("Exit status", "exit_status", std::mem_fn(&Failure::exit_code))
      .seconds("After", "seconds", std::mem_fn(&Failure::seconds))
      .text("Why", "why", std::mem_fn(&Failure::why));
  return columns.table("failures", "Scenes that were left out, and runs that were refused, timed out, crashed or failed.",
                       failures_of(study));
}

Table run_table(const Study& study) {
  Columns<StudyRun> columns;
  columns.text("Scene", "scene", std::mem_fn(&StudyRun::scene))
      .text("Run", "run", std::mem_fn(&StudyRun::label))
      .text("Method", "method", std::mem_fn(&StudyRun::method))
      .text("Status", "status", [](const StudyRun& run) { return status_text(run.status); })
      .text("Parameters", "parameters", [](const StudyRun& run) { return joined(run.parameters); })
      .whole("Seed", "seed", std::mem_fn(&StudyRun::seed))
      .whole("Threads", "threads", std::mem_fn(&StudyRun::threads))
      .text("Machine", "machine", std::mem_fn(&StudyRun::machine));
  for (const Stage stage : all_stages)
    columns.seconds(to_string(stage), std::string(to_string(stage)) + "_seconds",
                    [stage](const StudyRun& run) { return run.seconds_of(stage); });
  columns.seconds("Wall clock", "wall_seconds", std::mem_fn(&StudyRun::wall_seconds))
      .bytes("Method memory", "method_bytes", std::mem_fn(&StudyRun::method_bytes))
      .bytes("Peak memory", "peak_bytes", std::mem_fn(&StudyRun::peak_bytes));
  for (const std::string counter : {"closest_hit_rays", "occlusion_rays"})
    columns.count(counter, counter, [counter](const StudyRun& run) { return at(run.counters, counter); });
  return columns.table("runs", "Every run: parameters, seconds per stage, memory and rays.", study.runs);
}

}  // namespace gibench::report
