/// The error metrics, one row each: errors, comparisons of pictures, lists, reports and the README's table follow from it.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "common/core/rgb.h"
#include "common/metrics/error_value.h"
#include "common/metrics/value_metrics.h"

namespace gibench {

/// Which values of a metric are the better ones, and so how it is drawn.
enum class Better {
  smaller,         ///< drawn as it is, on a logarithmic axis
  nearer_to_zero,  ///< its absolute value is drawn, on a logarithmic axis
  nearer_to_one,   ///< 1 − value is drawn, on a logarithmic axis
  larger,          ///< drawn as it is, on a linear axis
  unknown,         ///< not in the table: drawn as it is, on a linear axis; smaller counts as better
};

/// The unit of a metric's values.
enum class MetricUnit {
  none,
  share,      ///< shown as a percentage
  of_values,  ///< W/m² at surface samples, W/(m² sr) in images
};

/// How value, noise floor and interval follow from an estimate over parts of a reference.
enum class Taken {
  as_square,          ///< unbiased: an estimate below 0 is 0
  as_root_of_square,  ///< the root of that
  with_sign,          ///< may be negative; the floor is the standard error
  between,            ///< the root of the product of two estimates, one too small on average and one too large
  as_largest,         ///< picks the value whose noise is largest
};

/// A metric of linear values.
struct ValueMetric {
  using Estimate = std::optional<MetricEstimate> (*)(std::span<const Rgb>, const ReferenceMeans&);  ///< empty: not defined
  Estimate estimate;
  Taken taken = Taken::as_square;
  Estimate at_least = nullptr;  ///< the smaller one of two; null where there is one
};

struct PictureComparison;  // of picture_errors.h

/// A metric of pictures as they are shown.
struct PictureMetric {
  /// Against a reference in replicates; empty where the picture is too small.
  std::optional<ErrorValue> (*error)(const PictureComparison&);
  /// Of two pictures of display values, width and height first; null for FLIP, which gives more than one number.
  std::optional<double> (*of_displayed)(int, int, std::span<const Rgb>, std::span<const Rgb>) = nullptr;
};

/// A row of the table.
struct Metric {
  std::string name;     ///< with its constants: "mape(0.01)"
  std::string title;    ///< as on an axis, of what is drawn: "Relative RMSE", "1 − SSIM"
  std::string meaning;  ///< one line; x is the method's value, r the reference's, A and B are the reference's halves
  Better better = Better::smaller;
  /// d log(error) / d log(time) of unbiased Monte Carlo; empty where none is known.
  std::optional<double> monte_carlo_slope = {};
  MetricUnit unit = MetricUnit::none;
  std::variant<ValueMetric, PictureMetric> function = {};
};

/// In the order in which they are listed.
const std::vector<Metric>& all_metrics();
/// The function of a metric of linear values, or of pictures; null where it is one of the other.
const ValueMetric* value_metric(const Metric& metric);
const PictureMetric* picture_metric(const Metric& metric);
/// Null where there is none of this name.
const Metric* find_metric(std::string_view name);

/// The metric that stands for all where only one is shown.
inline constexpr const char* headline_metric = "relative_rmse";

}  // namespace gibench
