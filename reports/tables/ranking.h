/// The cost of accuracy as one number: how much faster than the path tracer a run reached its error, and how the
/// configurations of a study compare across its scenes.
#pragma once

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

/// The curve of a scene. Runs below the noise floor are left out: their error is not known.
BaselineCurve baseline_curve(const Study& study, const std::string& scene, const ErrorKey& key);

/// Path tracer's time for the run's error over the run's time.
struct SpeedUp {
  double factor = 0.0;
  bool at_least = false;      ///< a lower bound: the run's error is below the noise floor, which stands in for it
  bool extrapolated = false;  ///< the path tracer was not run at that error
};
/// Empty where the curve or the run does not say; 1 for a run of the path tracer below the noise floor.
std::optional<SpeedUp> speed_up(const BaselineCurve& curve, const StudyRun& run, const ErrorKey& key);

/// One configuration on one scene.
struct RankedRun {
  std::optional<std::size_t> run;  ///< position in the study's runs; empty: not in the study
  std::optional<SpeedUp> speed_up;
  std::optional<int> error_rank;  ///< 1 is the smallest error on this scene; runs below the floor share a rank
  bool on_front = false;          ///< no other run of the scene is both faster and more accurate
};

/// One configuration (method and label) across the scenes.
struct RankingRow {
  std::string method, label;
  std::vector<RankedRun> scenes;              ///< in the order of the study's scenes
  int compared = 0;                           ///< scenes with a speed-up
  int not_done = 0;                           ///< refused, timed out, crashed, failed
  std::optional<double> geometric_mean = {};  ///< of the speed-ups
  bool at_least = false;                      ///< some speed-up in the mean is a lower bound
  std::optional<double> mean_error_rank = {};
  int on_front = 0;
};

/// Rows ordered by how many scenes they answer, then by the geometric mean of the speed-ups, then by error rank.
std::vector<RankingRow> rank(const Study& study, const ErrorKey& key);

}  // namespace gibench::report
