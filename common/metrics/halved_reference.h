/// A reference in replicates with the means that errors are taken against.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "common/metrics/replicas.h"
#include "common/metrics/value_metrics.h"

namespace gibench {

/// The means of a reference with their storage. The replicates outlive it.
struct HalvedReference {
  const Replicas& replicas;
  std::vector<Rgb> mean, half_a, half_b;
  std::array<std::vector<Rgb>, 3> thirds;  ///< empty for two replicates: metrics with weights are not defined then

  /// Throws InputError for fewer than two replicates or a mean that is not finite.
  explicit HalvedReference(const Replicas& set);
  ReferenceMeans means() const { return {mean, half_a, half_b, {thirds[0], thirds[1], thirds[2]}}; }
  std::vector<double> influences(const MetricEstimate& estimate) const;
};

/// Throws InputError for values that are not finite; `what` names them.
void check_finite(std::span<const Rgb> values, const std::string& what);

}  // namespace gibench
