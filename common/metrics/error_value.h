/// A value of an error metric with its interval and noise floor.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace gibench {

/// An error, as estimated against a reference with noise.
struct ErrorValue {
  double value = 0.0;
  double low = 0.0, high = 0.0;       ///< 95% interval over replicates, points and, where they were varied, seeds
  std::optional<double> noise_floor;  ///< in the metric's unit: what the reference's own noise would give
  bool resolved = true;               ///< the interval leaves out "no error"; otherwise its far end is all that is known
  /// Standard deviation of the value over the method's seeds; absent where only one was tried.
  std::optional<double> seed_deviation = {};
};
using ErrorTable = std::map<std::string, ErrorValue>;

}  // namespace gibench
