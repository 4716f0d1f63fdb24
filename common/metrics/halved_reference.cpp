#include "common/metrics/halved_reference.h"

#include "common/core/error.h"
#include "common/metrics/intervals.h"
#include "common/metrics/metric_terms.h"

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
  constexpr std::size_t groups = metric_terms::most_groups;
  if (set.count() > groups)
    for (std::size_t group = 0; group < groups; ++group) joined.push_back(set.every(groups, group));
}

ReferenceMeans HalvedReference::means() const {
  ReferenceMeans means{mean, half_a, half_b, {}};
  if (replicas.count() < 3) return means;
  const auto& groups = joined.empty() ? replicas.replicas : joined;
  means.groups.assign(groups.begin(), groups.end());
  return means;
}

std::vector<double> HalvedReference::influences(const MetricEstimate& estimate) const {
  if (!estimate.without_group.empty()) return delete_one_influences(estimate.without_group);
  return slope_influences(estimate.slope, replicas, mean);
}

}  // namespace gibench
