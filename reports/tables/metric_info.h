/// How each metric is named, plotted and compared.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/collect/study.h"

namespace gibench::report {

/// What is drawn and ranked for a value: always "the smaller the better" except for the value itself.
enum class Plotted { value, absolute, one_minus };

struct MetricInfo {
  std::string name;
  std::string title;    ///< as on an axis: "Relative RMSE"
  std::string meaning;  ///< one line; x is the method's value, r the reference's
  Plotted plotted = Plotted::value;
  bool logarithmic = true;
  bool higher_is_better = false;
  bool percent = false;   ///< shown as a percentage
  bool has_unit = false;  ///< has the unit of the values: W/m² at surface samples, W/(m² sr) in images
  /// d log(error) / d log(time) of unbiased Monte Carlo; empty where none is known.
  std::optional<double> monte_carlo_slope = {};
};

/// The known metrics, in the order in which they are offered.
const std::vector<MetricInfo>& known_metrics();
/// The known one, or a plain description of a metric that is not.
MetricInfo metric_info(const std::string& name);

/// The number drawn on the error axis.
double plotted_value(const MetricInfo& metric, double value);
/// A number that is smaller for a better result.
double badness(const MetricInfo& metric, double value);

/// Every combination that some run measured, in the order in which it is offered: surface before image, indirect
/// before total before direct, metrics as in known_metrics(). The first is the report's default.
std::vector<ErrorKey> measured_keys(const Study& study);

/// What an error is an error of: "indirect irradiance at the surface samples".
std::string describe(const ErrorKey& key);
/// The metric's title with its unit.
std::string axis_title(const ErrorKey& key);

}  // namespace gibench::report
