/// The standing of runs beside the most accurate one of their scene, by the intervals of differences.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "reports/collect/study.h"
#include "reports/tables/metric_info.h"

namespace gibench::report {

/// How a run's error stands beside the smallest one of its scene.
struct Standing {
  bool is_best = false;
  std::optional<Comparison> beside_best;  ///< its error minus the smallest; empty for that one
};
/// By the run's position, of those that were compared. The best one has the smallest error as it is shown, the first of equal
/// ones.
std::map<std::size_t, Standing> standings(const Study& study, std::size_t scene, const ErrorKey& key);

/// "best", "worse by 0.31 % [0.20, 0.42]", or "not told apart [-0.10, 0.42]".
std::string standing_text(const Metric& metric, const Standing& standing);

/// The comparisons of a scene's runs by one error.
const std::vector<Comparison>& comparisons_of(const Study& study, std::size_t scene, const ErrorKey& key);

/// "0.31 % [0.20, 0.42]": a difference of errors with its interval.
std::string difference_text(const Metric& metric, double difference, double low, double high);

}  // namespace gibench::report
