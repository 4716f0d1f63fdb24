#include "reports/tables/ranking.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <tuple>

namespace gibench::report {
namespace {

/// What is compared on one scene: the error as it is shown, which of one that is not resolved is its interval's far end, and the
/// time. What may be as large as another counts as no smaller.
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
  return Entry{run, shown_badness(metric, *error), record.transport_seconds(key.domain), error->resolved};
}

/// Ranks by error; equal ones share a rank.
void rank_errors(const std::vector<Entry>& entries, const std::map<std::size_t, RankedRun*>& ranked) {
  std::vector<double> errors;
  for (const Entry& entry : entries) errors.push_back(entry.error);
  std::ranges::sort(errors);
  for (const Entry& entry : entries)
    ranked.at(entry.run)->error_rank = static_cast<int>(1 + (std::ranges::lower_bound(errors, entry.error) - errors.begin()));
}

/// Marks the runs that no other run beats: by time without being less accurate, or by accuracy without being slower.
void mark_front(const std::vector<Entry>& entries, const std::map<std::size_t, RankedRun*>& ranked) {
  std::vector<Entry> timed;
  std::ranges::copy_if(entries, std::back_inserter(timed), [](const Entry& entry) { return entry.seconds.has_value(); });
  std::ranges::sort(timed, {}, [](const Entry& entry) { return std::tuple(*entry.seconds, entry.error, entry.run); });
  double smallest = std::numeric_limits<double>::infinity();  // of the faster ones
  for (auto first = timed.begin(); first != timed.end();) {
    const auto last = std::find_if(first, timed.end(), [&](const Entry& entry) { return *entry.seconds > *first->seconds; });
    std::for_each(first, last, [&](const Entry& entry) {
      ranked.at(entry.run)->on_front = entry.error < smallest && entry.error == first->error;
    });
    smallest = std::min(smallest, first->error);
    first = last;
  }
}

/// The geometric mean of factors with an interval each.
class FactorMean {
 public:
  void add(const SpeedUp& speed) {
    log_sum_ += std::log(speed.factor);
    widen(below_, speed.low, speed.factor);
    widen(above_, speed.high, speed.factor);
    ++count_;
  }
  void write(RankingRow& row) const {
    row.compared = count_;
    if (count_ == 0) return;
    row.geometric_mean = std::exp(log_sum_ / count_);
    if (below_.known) row.mean_low = *row.geometric_mean * std::exp(-std::sqrt(below_.squares) / count_);
    if (above_.known) row.mean_high = *row.geometric_mean * std::exp(std::sqrt(above_.squares) / count_);
  }

 private:
  /// The sum of squares on one side of the factors; not known where some factor's interval has no such end.
  struct Spread {
    double squares = 0.0;
    bool known = true;
  };

  /// Adds the square of the logarithm between a factor and an end of its interval.
  static void widen(Spread& spread, const std::optional<double>& end, double factor) {
    if (end && *end > 0.0) spread.squares += std::pow(std::log(*end / factor), 2);
    else spread.known = false;
  }

  double log_sum_ = 0.0;
  Spread below_, above_;
  int count_ = 0;
};

void summarise(const Study& study, RankingRow& row) {
  FactorMean mean;
  double rank_sum = 0.0;
  int ranked = 0;
  for (const RankedRun& cell : row.scenes) {
    if (!cell.run) continue;
    const RunStatus status = study.runs[*cell.run].status;
    if (status != RunStatus::done && status != RunStatus::skipped) ++row.not_done;
    if (cell.speed_up) {
      mean.add(*cell.speed_up);
      row.at_least = row.at_least || cell.speed_up->at_least;
      row.extrapolated = row.extrapolated || cell.speed_up->extrapolated;
    }
    if (cell.error_rank) {
      rank_sum += *cell.error_rank;
      ++ranked;
    }
    if (cell.on_front) ++row.on_front;
  }
  mean.write(row);
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

Baseline baseline_of(const Study& study, const std::string& scene, const ErrorKey& key, const std::string& machine) {
  const Metric metric = metric_info(key.metric);
  std::vector<std::pair<double, double>> points, low_ends, high_ends;
  for (const std::size_t run : study.runs_of(scene)) {
    if (study.runs[run].method != baseline_method || study.runs[run].machine != machine) continue;
    const auto entry = entry_of(study, run, key, metric);
    if (!entry || !entry->seconds || !entry->resolved) continue;
    points.emplace_back(*entry->seconds, entry->error);
    const auto interval = badness_interval(metric, *study.runs[run].error(key));
    low_ends.emplace_back(*entry->seconds, interval ? interval->first : entry->error);
    high_ends.emplace_back(*entry->seconds, interval ? interval->second : entry->error);
  }
  const auto through = [&](std::vector<std::pair<double, double>>& ends) {
    return BaselineCurve(std::move(ends), metric.monte_carlo_slope);
  };
  return {through(points), through(low_ends), through(high_ends)};
}

std::optional<SpeedUp> speed_up(const Baseline& baseline, const StudyRun& run, const ErrorKey& key) {
  const MeasuredError* error = run.error(key);
  const auto seconds = run.transport_seconds(key.domain);
  if (run.status != RunStatus::done || !error || !seconds || *seconds <= 0.0) return std::nullopt;
  // The path tracer's own error, unknown or not, takes the path tracer's time.
  if (!error->resolved && run.method == baseline_method) return SpeedUp{.factor = 1.0};
  const Metric metric = metric_info(key.metric);
  const auto at = baseline.errors.seconds_at(shown_badness(metric, *error));
  if (!at) return std::nullopt;
  SpeedUp speed{.factor = at->seconds / *seconds, .at_least = !error->resolved, .extrapolated = at->extrapolated};
  const auto interval = badness_interval(metric, *error);
  // A run of the path tracer lies on the curve with the very error that the curve has there.
  if (!interval || run.method == baseline_method) return speed;
  // The larger the run's error and the smaller the path tracer's, the sooner the path tracer is there.
  if (const auto soonest = baseline.low_ends.seconds_at(interval->second))
    speed.low = std::min(speed.factor, soonest->seconds / *seconds);
  if (const auto latest = baseline.high_ends.seconds_at(interval->first); latest && error->resolved)
    speed.high = std::max(speed.factor, latest->seconds / *seconds);
  return speed;
}

std::optional<SpeedUp> SpeedUps::of(const StudyRun& run) {
  const auto found = baselines_.find(run.machine);
  const Baseline& baseline = found != baselines_.end()
                                 ? found->second
                                 : baselines_.emplace(run.machine, baseline_of(study_, scene_, key_, run.machine)).first->second;
  return speed_up(baseline, run, key_);
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
    SpeedUps speed_ups(study, study.scenes[s].name, key);
    std::vector<Entry> entries;
    std::map<std::size_t, RankedRun*> ranked;
    for (const auto& [run, row] : row_of) {
      RankedRun& cell = rows[row].scenes[s];
      cell.run = run;
      cell.speed_up = speed_ups.of(study.runs[run]);
      ranked[run] = &cell;
      if (const auto entry = entry_of(study, run, key, metric)) entries.push_back(*entry);
    }
    rank_errors(entries, ranked);
    mark_front(entries, ranked);
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
