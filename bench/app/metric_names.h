/// The error metrics by name, for lists: what common/metrics computes, with its constants.
#pragma once

#include <span>

namespace gibench {

struct MetricName {
  const char* name;
  const char* meaning;  ///< one line: x is the method's value, r the reference, A and B its halves
};
std::span<const MetricName> metric_names();

}  // namespace gibench
