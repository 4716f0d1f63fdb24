#include "common/metrics/halved_reference.h"

#include "common/core/error.h"
#include "common/metrics/intervals.h"

namespace gibench {

void check_finite(std::span<const Rgb> values, const std::string& what) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!is_finite(values[i]))
      throw InputError(what + "[" + std::to_string(i) + "]", "is not finite, so that no error can be taken",
                       "give finite values");
}

HalvedReference::HalvedReference(const Replicas& set) : replicas(set) {
  if (set.count() < 2)
    throw InputError("reference", "errors need two replicates at least, and it has " + std::to_string(set.count()),
                     "make it with more replicates");
  mean = set.mean(), half_a = set.half(0), half_b = set.half(1);
  check_finite(mean, "reference");
  if (set.count() > 2) thirds = {set.third(0), set.third(1), set.third(2)};
}

std::vector<double> HalvedReference::influences(const MetricEstimate& estimate) const {
  return slope_influences(estimate.slope, replicas, mean);
}

}  // namespace gibench
