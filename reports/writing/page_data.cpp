#include "reports/writing/page_data.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "reports/collect/facts.h"
#include "reports/tables/at_a_glance.h"
#include "reports/tables/format.h"
#include "reports/tables/method_style.h"
#include "reports/tables/pair_tables.h"
#include "reports/tables/study_tables.h"

namespace gibench::report {
namespace {

/// A JavaScript statement; "</" is split so that the text is safe inside a script element too.
std::string assignment(const std::string& name, const Json& value) {
  const std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '/' && !safe.empty() && safe.back() == '<') safe += '\\';
    safe += c;
  }
  return fmt::format("gibench.{} = {};\n", name, safe);
}

template <class T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

Json facts_json(const Facts& facts) {
  Json list = Json::array();
  for (const auto& [name, value] : facts) list.push_back({name, value});
  return list;
}

Json texts_of(const std::vector<Cell>& cells) {
  Json texts = Json::array();
  for (const Cell& cell : cells) texts.push_back(cell.text);
  return texts;
}

Json table_json(const Table& whole) {
  const Table table = shown(whole);
  Json columns = Json::array(), rows = Json::array();
  for (const Column& column : table.columns) columns.push_back({{"title", column.title}, {"number", column.is_number}});
  for (const auto& row : table.rows) rows.push_back(texts_of(row));
  return {{"name", table.name}, {"caption", table.caption}, {"columns", columns}, {"rows", rows}};
}

Json metric_json(const Metric& metric) {
  return {{"name", metric.name},
          {"title", metric.title},
          {"meaning", metric.meaning},
          {"logarithmic", is_logarithmic(metric)},
          {"percent", is_percentage(metric)},
          {"higher_is_better", higher_is_better(metric)}};
}

/// The mark of one error: one that is not resolved is drawn at the end of its interval.
Json drawn_error(const Metric& metric, const MeasuredError& error) {
  Json entry = {{"y", plotted_value(metric, shown_value(metric, error))},
                {"unresolved", !error.resolved},
                {"text", error_text(metric, error)}};
  if (error.noise_floor) entry["floor"] = plotted_value(metric, *error.noise_floor);
  if (error.resolved && error.low && error.high) {
    const auto [low, high] = plotted_interval(metric, *error.low, *error.high);
    entry["low"] = low;
    entry["high"] = high;
  }
  return entry;
}

Json error_json(const StudyRun& run, const ErrorKey& key) {
  const MeasuredError* error = run.error(key);
  return error ? drawn_error(metric_info(key.metric), *error) : Json();
}

Json names_json(const EffectSet& effects) {
  Json names = Json::array();
  for (const Effect effect : effects) names.push_back(to_string(effect));
  return names;
}

Json effects_json(const EffectPlan& plan) {
  Json skipped = Json::array();
  for (const SkippedEffect& effect : plan.skipped) skipped.push_back({to_string(effect.effect), effect.why});
  return {{"called_for", names_json(plan.called_for)},
          {"simulated", names_json(plan.simulated)},
          {"missing", names_json(plan.missing)},
          {"skipped", skipped}};
}

Json run_json(const StudyRun& run) {
  Json seconds = Json::object(), counters = Json::array();
  for (const auto& [stage, value] : run.seconds) seconds[to_string(stage)] = value;
  for (const auto& [name, count] : run.counters) counters.push_back({name, large_count(count)});
  Json time = Json::object();
  for (const Domain domain : {Domain::surface, Domain::image})
    if (const auto value = run.transport_seconds(domain)) time[to_string(domain)] = *value;
  return {{"id", run.id},
          {"label", run.label},
          {"scene", run.scene},
          {"method", run.method},
          {"parameters", facts_json(run.parameters)},
          {"status", to_string(run.status)},
          {"status_text", status_text(run.status)},
          {"message", run.message},
          {"exit_code", or_null(run.exit_code)},
          {"wall", run.wall_seconds ? Json(duration(*run.wall_seconds)) : Json()},
          {"seed", or_null(run.seed)},
          {"threads", or_null(run.threads)},
          {"seconds", seconds},
          {"time", time},
          {"counters", counters},
          {"warnings", run.warnings},
          {"termination", run.termination ? to_string(*run.termination) : ""},
          {"effects", run.effects ? effects_json(*run.effects) : Json()},
          {"machine", run.machine},
          {"details", facts_json(run.details)}};
}

Json picture_json(const PagePicture& picture) {
  Json layers = Json::object();
  for (const auto& [name, layer] : picture.layers) layers[name] = {{"file", layer.file}, {"scale", layer.scale}};
  return {{"run", or_null(picture.run)}, {"width", picture.width}, {"height", picture.height}, {"layers", layers}};
}

/// [method, effects it lacks] for each method whose pictures of the scene are not complete.
Json missing_effects(const Study& study, const std::string& scene) {
  std::map<std::string, std::set<std::string>> missing;
  for (const std::size_t run : study.runs_of(scene))
    if (const auto& effects = study.runs[run].effects)
      for (const Effect effect : effects->missing) missing[study.runs[run].method].insert(to_string(effect));
  Json list = Json::array();
  for (const auto& [method, effects] : missing)
    if (!effects.empty()) list.push_back({method, effects});
  return list;
}

Json scene_json(const Study& study, std::size_t index, const std::vector<PagePicture>& pictures) {
  const StudyScene& scene = study.scenes[index];
  Json shown = Json::array();
  for (const PagePicture& picture : pictures) shown.push_back(picture_json(picture));
  return {{"name", scene.name},
          {"slug", scene_slug(study, index)},
          {"skipped", scene.skipped ? Json(*scene.skipped) : Json()},
          {"exposure", scene.exposure},
          {"facts", facts_json(scene.facts)},
          {"reference", facts_json(scene.reference)},
          {"missing", missing_effects(study, scene.name)},
          {"runs", study.runs_of(scene.name)},
          {"pictures", shown}};
}

Json ranking_json(const Study& study, const ErrorKey& key) {
  const std::vector<RankingRow> rows = rank(study, key);
  Json points = Json::array();
  for (const RankingRow& row : rows) {
    if (row.geometric_mean)
      points.push_back(
          {{"run", row.label}, {"method", row.method}, {"scene", ""}, {"factor", *row.geometric_mean}, {"kind", "mean"}});
    for (std::size_t s = 0; s < row.scenes.size(); ++s)
      if (const auto& speed = row.scenes[s].speed_up)
        points.push_back({{"run", row.label},
                          {"method", row.method},
                          {"scene", study.scenes[s].name},
                          {"factor", speed->factor},
                          {"kind", speed->at_least       ? "at least"
                                   : speed->extrapolated ? "extrapolated"
                                                         : "measured"}});
  }
  return {{"table", table_json(ranking_table(study, key, rows))}, {"points", points}};
}

Json glance_json(const Study& study, const ErrorKey& key) {
  const std::vector<GlanceRow> rows = glance_rows(study, key);
  return {{"sentence", glance_sentence(study, key, rows)}, {"table", table_json(glance_table(study, key, rows))}};
}

/// The points of the plot of both parts: one of each part that a run measured.
Json split_json(const Study& study, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Json points = Json::array();
  for (const StudyRun& run : study.runs) {
    if (run.status != RunStatus::done || !run.complete) continue;
    const auto add = [&](const char* part, const MeasuredError* error) {
      if (!error) return;
      Json point = drawn_error(metric, *error);
      point["run"] = run.label, point["scene"] = run.scene, point["method"] = run.method, point["part"] = part;
      points.push_back(std::move(point));
    };
    add("model", run.model_error(key));
    add("discretisation", run.discretisation_error(key));
  }
  return {{"table", table_json(split_table(study, key))}, {"bounces", table_json(bounce_table(study, key))}, {"points", points}};
}

Json bounded_json(const std::optional<Bounded>& number) {
  if (!number) return {};
  return {{"value", or_null(number->value)}, {"low", or_null(number->low)}, {"high", or_null(number->high)}};
}

Json relights_json(const Study& study) {
  Json list = Json::array();
  for (const StudyRelight& relight : study.relights)
    if (relight.frame_seconds() && relight.prepare_seconds)
      list.push_back({{"label", relight.label},
                      {"scene", relight.scene},
                      {"method", relight.method},
                      {"lights", relight.lights},
                      {"prepare", *relight.prepare_seconds},
                      {"frame", *relight.frame_seconds()},
                      {"path_tracing", bounded_json(relight.path_tracing_seconds)},
                      {"frames_that_pay", bounded_json(relight.frames_that_pay)},
                      {"sentence", relight_sentence(relight)}});
  return {{"list", list}, {"table", table_json(relight_table(study))}, {"frames", table_json(relit_frame_table(study))}};
}

}  // namespace

std::string page_data(const Study& study, const std::vector<std::vector<PagePicture>>& pictures,
                      const std::vector<std::string>& warnings) {
  const std::vector<ErrorKey> keys = measured_keys(study);
  Json methods = Json::array(), metrics = Json::object(), key_list = Json::array(), scenes = Json::array(), runs = Json::array();
  for (const MethodStyle& style : method_styles(study))
    methods.push_back({{"name", style.method}, {"colour", style.colour}, {"shape", style.shape}, {"dash", style.dash}});
  for (const ErrorKey& key : keys) {
    metrics[key.metric] = metric_json(metric_info(key.metric));
    key_list.push_back({{"domain", to_string(key.domain)},
                        {"component", to_string(key.component)},
                        {"metric", key.metric},
                        {"of", describe(key)},
                        {"axis", axis_title(key)}});
  }
  for (std::size_t s = 0; s < study.scenes.size(); ++s) scenes.push_back(scene_json(study, s, pictures.at(s)));
  for (const StudyRun& run : study.runs) runs.push_back(run_json(run));
  return assignment("study", {{"name", study.name},
                              {"version", study.version},
                              {"commit", study.commit},
                              {"created", study.created},
                              {"machine", facts_json(study.machine)},
                              {"settings", facts_json(study.settings)},
                              {"warnings", warnings},
                              {"methods", methods},
                              {"metrics", metrics},
                              {"keys", key_list},
                              {"scenes", scenes},
                              {"runs", runs},
                              {"errors", Json::object()},
                              {"relights", relights_json(study)},
                              {"calls", table_json(call_table(study))},
                              {"evidence", table_json(evidence_table(study))},
                              {"effect_matrix", table_json(effect_matrix(study))},
                              {"effects", table_json(effect_table(study))},
                              {"failures", table_json(failure_table(study))}});
}

std::string error_data(const Study& study, const ErrorKey& key, std::size_t position) {
  Json runs = Json::array(), tables = Json::array(), pairs = Json::array();
  for (const StudyRun& run : study.runs) runs.push_back(error_json(run, key));
  for (std::size_t scene = 0; scene < study.scenes.size(); ++scene) {
    tables.push_back(table_json(scene_table(study, scene, key)));
    pairs.push_back(table_json(pair_table(study, scene, key)));
  }
  return assignment(fmt::format("study.errors[{}]", position), {{"runs", runs},
                                                                {"glance", glance_json(study, key)},
                                                                {"ranking", ranking_json(study, key)},
                                                                {"split", split_json(study, key)},
                                                                {"tables", tables},
                                                                {"pairs", pairs}});
}

std::string plot_templates(const std::filesystem::path& folder) {
  Json templates = Json::object();
  const std::string ending = ".vl.json";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.ends_with(ending)) templates[name.substr(0, name.size() - ending.size())] = read_json_file(entry.path());
  }
  return assignment("plots", templates);
}

}  // namespace gibench::report
