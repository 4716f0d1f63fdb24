/// A value of an error metric with its interval and noise floor.
#pragma once

#include <map>
#include <optional>
#include <string>

namespace gibench {

/// An error, as estimated against a reference with noise.
struct ErrorValue {
  double value = 0.0;
  double low = 0.0, high = 0.0;       ///< 95% interval over the reference replicates (jackknife, Student t; see intervals.h)
  std::optional<double> noise_floor;  ///< in the metric's unit: what the reference's own noise would give
  bool below_noise_floor = false;     ///< then `value` says no more than that the error is small
};
using ErrorTable = std::map<std::string, ErrorValue>;

}  // namespace gibench
