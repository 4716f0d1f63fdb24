/// The cost of accuracy as one number: how much faster than the path tracer a run reached its error, and how the
/// configurations of a study compare across its scenes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/collect/study.h"
#include "reports/tables/metric_info.h"

namespace gibench::report {

/// The method with whose times the others' are compared.
inline constexpr const char* baseline_method = "pathtracer";

/// The path tracer's error against time on one scene: the runs that no cheaper run beats, joined by straight lines
/// in log-log, and beyond its ends continued with the Monte Carlo slope of the metric.
class BaselineCurve {
 public:
  struct Answer {
    double seconds = 0.0;
    bool extrapolated = false;
  };
  /// (seconds, error) pairs, both positive, in any order.
  BaselineCurve(std::vector<std::pair<double, double>> points, std::optional<double> slope);
  /// Time that the path tracer needs for `error`; empty without points, or beyond their ends without a slope.
  std::optional<Answer> seconds_at(double error) const;

 private:
  std::vector<std::pair<double, double>> points_;
  std::optional<double> slope_;
};

/// The path tracer on one scene: through its errors, and through the ends of their 95% intervals.
struct Baseline {
  BaselineCurve errors, low_ends, high_ends;
};
/// Of the path tracer's runs on one machine; those whose error is not resolved are left out: their error is not known.
Baseline baseline_of(const Study& study, const std::string& scene, const ErrorKey& key, const std::string& machine);

/// Path tracer's time for the run's error over the run's time.
struct SpeedUp {
  double factor = 0.0;
  /// What the 95% intervals of the run's error and of the path tracer's errors leave room for, taken at their worst together;
  /// seconds are taken as exact. Empty where an interval or the curve does not say.
  std::optional<double> low = {}, high = {};
  bool at_least = false;      ///< a lower bound: the run's error is not resolved, its interval's far end stands in for it
  bool extrapolated = false;  ///< the path tracer was not run at that error
};
/// Empty where the curve or the run does not say; 1 for a run of the path tracer whose error is not resolved.
std::optional<SpeedUp> speed_up(const Baseline& baseline, const StudyRun& run, const ErrorKey& key);

/// The speed-ups on one scene, each over the path tracer on the run's own machine.
class SpeedUps {
 public:
  SpeedUps(const Study& study, std::string scene, ErrorKey key) : study_(study), scene_(std::move(scene)), key_(std::move(key)) {}
  std::optional<SpeedUp> of(const StudyRun& run);

 private:
  const Study& study_;
  std::string scene_;
  ErrorKey key_;
  std::map<std::string, Baseline> baselines_;  ///< by machine
};

/// One configuration on one scene.
struct RankedRun {
  std::optional<std::size_t> run;  ///< position in the study's runs; empty: not in the study
  std::optional<SpeedUp> speed_up;
  /// 1 is the smallest error on this scene, that of an error that is not resolved taken at its interval's far end.
  std::optional<int> error_rank;
  bool on_front = false;  ///< no other run of the scene is both faster and more accurate, errors taken likewise
};

/// One configuration (method and label) across the scenes.
struct RankingRow {
  std::string method, label;
  std::vector<RankedRun> scenes;              ///< in the order of the study's scenes
  int compared = 0;                           ///< scenes with a speed-up
  int not_done = 0;                           ///< refused, timed out, crashed, failed
  std::optional<double> geometric_mean = {};  ///< of the speed-ups
  /// The mean's interval, the scenes' intervals taken as independent (their logarithms added as squares); each end empty where
  /// some scene's is.
  std::optional<double> mean_low = {}, mean_high = {};
  bool at_least = false;      ///< some speed-up in the mean is a lower bound
  bool extrapolated = false;  ///< the path tracer was not run at the error of some speed-up in the mean
  std::optional<double> mean_error_rank = {};
  int on_front = 0;
};

/// Rows ordered by how many scenes they answer, then by the geometric mean of the speed-ups, then by error rank.
std::vector<RankingRow> rank(const Study& study, const ErrorKey& key);

}  // namespace gibench::report
