/// Tables of what scenes call for, and of what methods lack.
#include <algorithm>
#include <functional>
#include <optional>

#include "reports/tables/format.h"
#include "reports/tables/study_tables.h"
#include "reports/tables/table_columns.h"

namespace gibench::report {
namespace {

/// A run of all light paths has no model error: that is known, not measured.
Cell model_cell(const Metric& metric, bool complete, const MeasuredError* error) {
  return complete ? Cell{"none: all light paths", "0"} : error_cell(metric, error);
}

std::string missing_of(const StudyRun& run) { return run.effects ? names_of(run.effects->missing) : std::string(); }

const MeasuredError* at_key(const std::map<ErrorKey, MeasuredError>& errors, const ErrorKey& key) {
  const auto found = errors.find(key);
  return found == errors.end() ? nullptr : &found->second;
}

std::string verdict(bool called_for) { return called_for ? "called for" : "not called for"; }

/// What a scene says of one effect, or of its bounces.
struct EvidenceRow {
  std::string scene, effect, verdict, evidence;
};

/// Both parts of an error of a run.
struct SplitRow {
  const StudyRun& run;
  const MeasuredError *model, *discretisation;
};

struct BounceRow {
  const StudyRun& run;
  const StudyRun::Bounce& bounce;
  const MeasuredError *model, *discretisation;
};

/// The columns of both parts, each with its noise floor.
template <class Row, class Complete>
void add_parts(Columns<Row>& columns, const Metric& metric, Complete complete) {
  columns
      .cells({"Model error", "model_error"},
             [&metric, complete](const Row& row) { return model_cell(metric, complete(row), row.model); })
      .error_ends("model_error", std::mem_fn(&Row::model))
      .cells({"Noise floor", "model_noise_floor"}, [&metric](const Row& row) { return floor_cell(metric, row.model); })
      .error("Discretisation error", "discretisation_error", metric, std::mem_fn(&Row::discretisation))
      .cells({"Noise floor", "discretisation_noise_floor"},
             [&metric](const Row& row) { return floor_cell(metric, row.discretisation); });
}

}  // namespace

Table call_table(const Study& study) {
  Columns<StudyScene> columns;
  columns.text("Scene", "scene", std::mem_fn(&StudyScene::name));
  EffectSet known;
  std::vector<StudyScene> rows;
  for (const StudyScene& scene : study.scenes) {
    if (!scene.effects.empty()) rows.push_back(scene);
    for (const EffectEvidence& evidence : scene.effects) {
      if (!known.insert(evidence.effect).second) continue;
      const char* name = to_string(evidence.effect);
      columns.text(name, name, [effect = evidence.effect](const StudyScene& row) {
        const auto found = std::ranges::find(row.effects, effect, &EffectEvidence::effect);
        return found == row.effects.end() ? "" : verdict(found->called_for);
      });
    }
  }
  columns.text("Bounces", "bounces", std::mem_fn(&StudyScene::bounces));
  return columns.table("scene-effects", "The effects that each scene calls for, and how many reflections its light needs.", rows);
}

Table evidence_table(const Study& study) {
  Columns<EvidenceRow> columns;
  columns.text("Scene", "scene", std::mem_fn(&EvidenceRow::scene))
      .text("Effect", "effect", std::mem_fn(&EvidenceRow::effect))
      .text("Verdict", "verdict", std::mem_fn(&EvidenceRow::verdict))
      .text("Evidence", "evidence", std::mem_fn(&EvidenceRow::evidence));
  std::vector<EvidenceRow> rows;
  for (const StudyScene& scene : study.scenes) {
    for (const EffectEvidence& effect : scene.effects)
      rows.push_back({scene.name, to_string(effect.effect), verdict(effect.called_for), effect.why});
    if (!scene.bounces.empty()) rows.push_back({scene.name, "bounces", scene.bounces, scene.bounce_bound});
  }
  return columns.table("scene-evidence", "Why each scene calls for an effect or not.", rows);
}

Table split_table(const Study& study, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Columns<SplitRow> columns;
  columns.text("Scene", "scene", [](const SplitRow& row) { return row.run.scene; })
      .text("Run", "run", [](const SplitRow& row) { return row.run.label; })
      .text("Method", "method", [](const SplitRow& row) { return row.run.method; })
      .text("Missing", "missing", [](const SplitRow& row) { return missing_of(row.run); });
  add_parts(columns, metric, [](const SplitRow& row) { return row.run.complete == true; });
  columns.error("Total error", "total_error", metric, [&](const SplitRow& row) { return row.run.error(key); })
      .text("Light paths", "light_paths", [](const SplitRow& row) { return row.run.light_paths; });
  std::vector<SplitRow> rows;
  for (const StudyRun& run : study.runs)
    if (run.status == RunStatus::done && run.complete && run.error(key))
      rows.push_back({run, run.model_error(key), run.discretisation_error(key)});
  return columns.table("error-split",
                       metric.title + " of " + describe(key) +
                           " in two parts. Model error: the reference of the light paths that the method simulates against that "
                           "of all. Discretisation error: the method against its own paths' reference. Brackets: 95% interval.",
                       rows);
}

Table bounce_table(const Study& study, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Columns<BounceRow> columns;
  columns.text("Scene", "scene", [](const BounceRow& row) { return row.run.scene; })
      .text("Run", "run", [](const BounceRow& row) { return row.run.label; })
      .whole("Bounce", "bounce", [](const BounceRow& row) { return row.bounce.number; });
  add_parts(columns, metric, [](const BounceRow& row) { return row.bounce.complete; });
  std::vector<BounceRow> rows;
  for (const StudyRun& run : study.runs)
    for (const StudyRun::Bounce& bounce : run.bounces)
      if (const MeasuredError* own = at_key(bounce.discretisation_errors, key))
        rows.push_back({run, bounce, at_key(bounce.model_errors, key), own});
  return columns.table("error-per-bounce", metric.title + " of each bounce order separately, " + describe(key) + ".", rows);
}

}  // namespace gibench::report
