#include "reports/tables/standing.h"

#include <fmt/format.h>

#include <set>

#include "reports/tables/format.h"

namespace gibench::report {
namespace {

/// "[0.20, 0.42]" in the unit of error_value.
std::string interval_text(const Metric& metric, double low, double high) {
  const double scale = is_percentage(metric) ? 100.0 : 1.0;
  return fmt::format("[{}, {}]", significant(low * scale), significant(high * scale));
}

}  // namespace

std::map<std::size_t, Standing> standings(const Study& study, std::size_t scene, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  std::set<std::size_t> runs;
  for (const Comparison& comparison : comparisons_of(study, scene, key)) runs.insert({comparison.run, comparison.other});
  std::map<std::size_t, Standing> standings;
  std::optional<std::size_t> best;
  const auto badness_of = [&](std::size_t run) { return shown_badness(metric, *study.runs[run].error(key)); };
  for (const std::size_t run : runs)
    if (!best || badness_of(run) < badness_of(*best)) best = run;
  for (const std::size_t run : runs)
    standings[run] = {run == *best, run == *best ? std::nullopt : study.scenes[scene].comparison(key, run, *best)};
  return standings;
}

std::string standing_text(const Metric& metric, const Standing& standing) {
  if (standing.is_best) return "best";
  if (!standing.beside_best) return std::string(dash);
  const Comparison& beside = *standing.beside_best;
  if (!beside.told_apart()) return "not told apart " + interval_text(metric, beside.low, beside.high);
  if (beside.difference > 0.0) return "worse by " + difference_text(metric, beside.difference, beside.low, beside.high);
  return "better by " + difference_text(metric, -beside.difference, -beside.high, -beside.low);
}

const std::vector<Comparison>& comparisons_of(const Study& study, std::size_t scene, const ErrorKey& key) {
  static const std::vector<Comparison> none;
  const auto found = study.scenes[scene].comparisons.find(key);
  return found == study.scenes[scene].comparisons.end() ? none : found->second;
}

std::string difference_text(const Metric& metric, double difference, double low, double high) {
  return error_value(metric, difference) + " " + interval_text(metric, low, high);
}

}  // namespace gibench::report
