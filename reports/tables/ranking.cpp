#include "reports/tables/ranking.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

namespace gibench::report {
namespace {

/// What is compared on one scene: the drawn error (the floor for a run below it) and the time.
struct Entry {
  std::size_t run;
  double error;
  std::optional<double> seconds;
  bool resolved;
};

std::optional<Entry> entry_of(const Study& study, std::size_t run, const ErrorKey& key, const Metric& metric) {
  const StudyRun& record = study.runs[run];
  const MeasuredError* error = record.error(key);
  if (record.status != RunStatus::done || !error) return std::nullopt;
  return Entry{run, badness(metric, shown_value(metric, *error)), record.transport_seconds(key.domain), error->resolved};
}

void rank_scene(const std::vector<Entry>& entries, const std::map<std::size_t, RankedRun*>& ranked) {
  for (const Entry& entry : entries) {
    int better = 0;
    bool beaten = !entry.seconds;
    for (const Entry& other : entries) {
      const bool tie = !entry.resolved && !other.resolved;
      const bool more_accurate = !tie && (other.error < entry.error || (!other.resolved && entry.resolved));
      const bool as_accurate = tie || other.error <= entry.error;
      if (more_accurate) ++better;
      if (other.run == entry.run || !entry.seconds || !other.seconds) continue;
      const bool faster = *other.seconds < *entry.seconds;
      const bool as_fast = *other.seconds <= *entry.seconds;
      if ((faster && as_accurate) || (as_fast && more_accurate)) beaten = true;
    }
    RankedRun& row = *ranked.at(entry.run);
    row.error_rank = better + 1;
    row.on_front = !beaten;
  }
}

void summarise(const Study& study, RankingRow& row) {
  double log_sum = 0.0, rank_sum = 0.0;
  int ranked = 0;
  for (const RankedRun& cell : row.scenes) {
    if (!cell.run) continue;
    const RunStatus status = study.runs[*cell.run].status;
    if (status != RunStatus::done && status != RunStatus::skipped) ++row.not_done;
    if (cell.speed_up) {
      log_sum += std::log(cell.speed_up->factor);
      row.at_least = row.at_least || cell.speed_up->at_least;
      ++row.compared;
    }
    if (cell.error_rank) {
      rank_sum += *cell.error_rank;
      ++ranked;
    }
    if (cell.on_front) ++row.on_front;
  }
  if (row.compared > 0) row.geometric_mean = std::exp(log_sum / row.compared);
  if (ranked > 0) row.mean_error_rank = rank_sum / ranked;
}

}  // namespace

BaselineCurve::BaselineCurve(std::vector<std::pair<double, double>> points, std::optional<double> slope) : slope_(slope) {
  std::sort(points.begin(), points.end());
  for (const auto& [seconds, error] : points)
    if (seconds > 0.0 && error > 0.0 && (points_.empty() || error < points_.back().second)) points_.emplace_back(seconds, error);
}

std::optional<BaselineCurve::Answer> BaselineCurve::seconds_at(double error) const {
  if (points_.empty() || !(error > 0.0)) return std::nullopt;
  const auto beyond = [&](const std::pair<double, double>& end) -> std::optional<Answer> {
    if (error == end.second) return Answer{end.first, false};
    if (!slope_) return std::nullopt;
    return Answer{end.first * std::pow(error / end.second, 1.0 / *slope_), true};
  };
  if (error >= points_.front().second) return beyond(points_.front());
  if (error <= points_.back().second) return beyond(points_.back());
  const auto after = std::find_if(points_.begin(), points_.end(), [error](const auto& point) { return point.second <= error; });
  const auto before = after - 1;
  const double share = std::log(error / before->second) / std::log(after->second / before->second);
  return Answer{before->first * std::pow(after->first / before->first, share), false};
}

BaselineCurve baseline_curve(const Study& study, const std::string& scene, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  std::vector<std::pair<double, double>> points;
  for (const std::size_t run : study.runs_of(scene)) {
    if (study.runs[run].method != baseline_method) continue;
    const auto entry = entry_of(study, run, key, metric);
    if (entry && entry->seconds && entry->resolved) points.emplace_back(*entry->seconds, entry->error);
  }
  return {std::move(points), metric.monte_carlo_slope};
}

std::optional<SpeedUp> speed_up(const BaselineCurve& curve, const StudyRun& run, const ErrorKey& key) {
  const MeasuredError* error = run.error(key);
  const auto seconds = run.transport_seconds(key.domain);
  if (run.status != RunStatus::done || !error || !seconds || *seconds <= 0.0) return std::nullopt;
  // The path tracer's own error, unknown or not, takes the path tracer's time.
  if (!error->resolved && run.method == baseline_method) return SpeedUp{.factor = 1.0};
  const Metric metric = metric_info(key.metric);
  const auto at = curve.seconds_at(badness(metric, shown_value(metric, *error)));
  if (!at) return std::nullopt;
  return SpeedUp{at->seconds / *seconds, !error->resolved, at->extrapolated};
}

std::vector<RankingRow> rank(const Study& study, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  std::vector<RankingRow> rows;
  // Runs of one scene may share a label: the second of a label is a row of its own.
  std::map<std::tuple<std::string, std::string, int>, std::size_t> position;
  for (std::size_t s = 0; s < study.scenes.size(); ++s) {
    std::map<std::pair<std::string, std::string>, int> seen;
    std::map<std::size_t, std::size_t> row_of;
    for (const std::size_t run : study.runs_of(study.scenes[s].name)) {
      const StudyRun& record = study.runs[run];
      const int occurrence = seen[{record.method, record.label}]++;
      const auto [found, is_new] = position.try_emplace({record.method, record.label, occurrence}, rows.size());
      if (is_new)
        rows.push_back({.method = record.method, .label = record.label, .scenes = std::vector<RankedRun>(study.scenes.size())});
      row_of[run] = found->second;
    }
    const BaselineCurve curve = baseline_curve(study, study.scenes[s].name, key);
    std::vector<Entry> entries;
    std::map<std::size_t, RankedRun*> ranked;
    for (const auto& [run, row] : row_of) {
      RankedRun& cell = rows[row].scenes[s];
      cell.run = run;
      cell.speed_up = speed_up(curve, study.runs[run], key);
      ranked[run] = &cell;
      if (const auto entry = entry_of(study, run, key, metric)) entries.push_back(*entry);
    }
    rank_scene(entries, ranked);
  }
  for (RankingRow& row : rows) summarise(study, row);
  std::stable_sort(rows.begin(), rows.end(), [](const RankingRow& a, const RankingRow& b) {
    const auto order = [](const RankingRow& row) {
      return std::tuple(-row.compared, -row.geometric_mean.value_or(0.0), row.mean_error_rank.value_or(1e9));
    };
    return order(a) < order(b);
  });
  return rows;
}

}  // namespace gibench::report
