#include "reports/tables/at_a_glance.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "reports/tables/format.h"
#include "reports/tables/table_columns.h"

namespace gibench::report {
namespace {

ErrorKey key_at(ErrorKey key, Domain domain) {
  key.domain = domain;
  return key;
}

/// "3.4×", "≥ 3.4×", "3.4× * [2.1, 5.0]".
std::string speed_text(const SpeedUp& speed) {
  std::string text = (speed.at_least ? "≥ " : "") + factor(speed.factor) + (speed.extrapolated ? " *" : "");
  if (!speed.at_least && speed.low && speed.high)
    text += fmt::format(" [{}, {}]", significant(*speed.low), significant(*speed.high));
  return text;
}

/// "92.3 k", "never".
std::string count_text(double number) {
  if (std::isinf(number)) return "never";
  const double whole = std::max(1.0, std::ceil(number));
  return whole < 1e15 ? large_count(static_cast<std::uint64_t>(whole)) : significant(whole);
}

/// "92.3 k [61.0 k, never]", "≤ 8 *", "never"; nothing is known of an error that is not resolved and does not pay at its far end.
Cell even_cell(const std::optional<BreakEven>& even) {
  if (!even) return text_cell("");
  if (even->at_most && std::isinf(even->number)) return {"undecided", ""};
  std::string text = (even->at_most ? "≤ " : "") + count_text(even->number);
  if (even->extrapolated && std::isfinite(even->number)) text += " *";
  if (!even->at_most && even->low && even->high && std::isfinite(*even->low))
    text += fmt::format(" [{}, {}]", count_text(*even->low), count_text(*even->high));
  return {text, exact(even->number)};
}

std::string missing_text(const StudyRun& run) {
  std::string text;
  if (run.effects)
    for (const Effect effect : run.effects->missing) text += (text.empty() ? "" : ", ") + std::string(to_string(effect));
  return text.empty() ? "" : "lacks " + text;
}

std::string verdict_text(const GlanceRow& row) {
  if (!row.speed_up) return "";
  switch (verdict_of(*row.speed_up)) {
    case Verdict::ahead: return "ahead";
    case Verdict::behind: return "behind";
    case Verdict::undecided: break;
  }
  return "undecided";
}

/// "a, b and c".
std::string listed(const std::vector<std::string>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i == 0 ? "" : i + 1 == parts.size() ? " and " : ", ") + parts[i];
  return text;
}

/// The verdicts of one scene's configurations.
struct SceneVerdicts {
  const GlanceRow* best = nullptr;  ///< the surest among those ahead
  int ahead = 0, behind = 0, undecided = 0;

  void add(const GlanceRow& row) {
    const Verdict verdict = verdict_of(*row.speed_up);
    if (verdict == Verdict::ahead) {
      ++ahead;
      if (best == nullptr || sure_factor(row) > sure_factor(*best)) best = &row;
    } else {
      ++(verdict == Verdict::behind ? behind : undecided);
    }
  }
  static double sure_factor(const GlanceRow& row) { return row.speed_up->low.value_or(row.speed_up->factor); }
};

std::string best_text(const Study& study, const GlanceRow& row) {
  const SpeedUp& speed = *row.speed_up;
  return fmt::format("{} on {} ({}{})", study.runs[row.run].label, study.scenes[row.scene].name,
                     speed.at_least ? "at least " : "", factor(speed.factor));
}

/// "On 4 of 5 scenes a method reaches", "On none of 5 scenes does a method reach".
std::string opening(std::size_t count, std::size_t of) {
  const char* scenes = of == 1 ? "scene" : "scenes";
  return count == 0 ? fmt::format("On none of {} {} does a method reach", of, scenes)
                    : fmt::format("On {} of {} {} a method reaches", count, of, scenes);
}

}  // namespace

Verdict verdict_of(const SpeedUp& speed) {
  if (speed.at_least) return speed.factor > 1.0 ? Verdict::ahead : Verdict::undecided;
  if (speed.low.value_or(speed.factor) > 1.0) return Verdict::ahead;
  return speed.high.value_or(speed.factor) < 1.0 ? Verdict::behind : Verdict::undecided;
}

std::optional<BreakEven> break_even(const StudyRun& run, const std::optional<SpeedUp>& speed, Domain domain, double asked) {
  const auto all = run.transport_seconds(domain), shading = run.shade_seconds(domain);
  if (!speed || !all || !shading || !(asked > 0.0)) return std::nullopt;
  const double once = *all - *shading, each = *shading / asked;
  const auto number_at = [&](double factor) {
    const double path_tracing_each = factor * *all / asked;
    return path_tracing_each > each ? once / (path_tracing_each - each) : std::numeric_limits<double>::infinity();
  };
  BreakEven even{.number = number_at(speed->factor), .at_most = speed->at_least, .extrapolated = speed->extrapolated};
  if (speed->high) even.low = number_at(*speed->high);
  if (speed->low) even.high = number_at(*speed->low);
  return even;
}

std::vector<GlanceRow> glance_rows(const Study& study, const ErrorKey& key) {
  std::vector<GlanceRow> rows;
  for (std::size_t s = 0; s < study.scenes.size(); ++s) {
    const std::string& scene = study.scenes[s].name;
    SpeedUps shown(study, scene, key), at_points(study, scene, key_at(key, Domain::surface)),
        in_pictures(study, scene, key_at(key, Domain::image));
    const auto first = static_cast<std::ptrdiff_t>(rows.size());
    for (const std::size_t position : study.runs_of(scene)) {
      const StudyRun& run = study.runs[position];
      if (run.method == baseline_method || run.status != RunStatus::done || run.error(key) == nullptr) continue;
      rows.push_back({s, position, shown.of(run),
                      break_even(run, at_points.of(run), Domain::surface, static_cast<double>(run.surface_samples)),
                      break_even(run, in_pictures.of(run), Domain::image, 1.0)});
    }
    std::stable_sort(rows.begin() + first, rows.end(), [](const GlanceRow& a, const GlanceRow& b) {
      const auto order = [](const GlanceRow& row) { return row.speed_up ? row.speed_up->factor : 0.0; };
      return order(a) > order(b);
    });
  }
  return rows;
}

Table glance_table(const Study& study, const ErrorKey& key, const std::vector<GlanceRow>& rows) {
  const Metric metric = metric_info(key.metric);
  const auto run_of = [&study](const GlanceRow& row) -> const StudyRun& { return study.runs[row.run]; };
  const auto speed_cell = [](const GlanceRow& row) {
    return row.speed_up ? Cell{speed_text(*row.speed_up), exact(row.speed_up->factor)} : text_cell("");
  };
  const auto end_of = [](std::optional<BreakEven> GlanceRow::*asked, std::optional<double> BreakEven::*end) {
    return [asked, end](const GlanceRow& row) { return row.*asked ? (*(row.*asked)).*end : std::nullopt; };
  };
  Columns<GlanceRow> columns;
  columns.text("Scene", "scene", [&study](const GlanceRow& row) { return study.scenes[row.scene].name; })
      .text("Method", "method", [run_of](const GlanceRow& row) { return run_of(row).method; })
      .text("Run", "run", [run_of](const GlanceRow& row) { return run_of(row).label; })
      .error(metric.title, metric.name, metric, [run_of, key](const GlanceRow& row) { return run_of(row).error(key); })
      .seconds("Time", "seconds", [run_of, key](const GlanceRow& row) { return run_of(row).transport_seconds(key.domain); })
      .bytes("Method memory", "method_bytes", [run_of](const GlanceRow& row) { return run_of(row).method_bytes; })
      .cells({"Speed-up", "speed_up"}, speed_cell)
      .text("Verdict", "verdict", verdict_text)
      .cells({"Pays from points", "pays_from_points"}, [](const GlanceRow& row) { return even_cell(row.points); })
      .in_csv("pays_from_points_ci95_low", end_of(&GlanceRow::points, &BreakEven::low), number_cell)
      .in_csv("pays_from_points_ci95_high", end_of(&GlanceRow::points, &BreakEven::high), number_cell)
      .cells({"Pays from pictures", "pays_from_pictures"}, [](const GlanceRow& row) { return even_cell(row.pictures); })
      .in_csv("pays_from_pictures_ci95_low", end_of(&GlanceRow::pictures, &BreakEven::low), number_cell)
      .in_csv("pays_from_pictures_ci95_high", end_of(&GlanceRow::pictures, &BreakEven::high), number_cell)
      .text("Light paths", "lacks", [run_of](const GlanceRow& row) { return missing_text(run_of(row)); });
  return columns.table(
      "at-a-glance",
      fmt::format("What each configuration costs and gets right: {} of {}, its time and memory, the path tracer's time for the "
                  "same error "
                  "over its own, and from how many points or pictures under the same lights it is the cheaper one.",
                  metric.title, describe(key)),
      rows);
}

std::string glance_sentence(const Study& study, const ErrorKey& key, const std::vector<GlanceRow>& rows) {
  std::map<std::size_t, SceneVerdicts> scenes;
  for (const GlanceRow& row : rows)
    if (row.speed_up) scenes[row.scene].add(row);
  if (scenes.empty()) return "No run can be compared with path tracing.";
  std::vector<std::string> ahead, behind, undecided;
  for (const auto& [scene, verdicts] : scenes) {
    if (verdicts.best != nullptr) ahead.push_back(best_text(study, *verdicts.best));
    else (verdicts.undecided > 0 ? undecided : behind).push_back(study.scenes[scene].name);
  }
  std::string text =
      fmt::format("{} its error in the {} sooner than path tracing would", opening(ahead.size(), scenes.size()), describe(key));
  if (!ahead.empty()) text += ": " + listed(ahead);
  text += ".";
  if (!behind.empty()) text += fmt::format(" Path tracing is ahead of all of them on {}.", listed(behind));
  if (!undecided.empty()) text += fmt::format(" The intervals leave it open on {}.", listed(undecided));
  return text;
}

}  // namespace gibench::report
