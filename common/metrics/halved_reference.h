/// A reference in replicates with the means that errors are taken against.
#pragma once

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
  /// Means of the replicates g, g + 8, …, where there are more than eight.
  std::vector<std::vector<Rgb>> joined;

  /// Throws InputError for fewer than two replicates or a mean that is not finite.
  explicit HalvedReference(const Replicas& set);
  /// With up to eight groups of replicates; none for two replicates, with which metrics with weights are not defined.
  ReferenceMeans means() const;
  /// Of the replicates, or of their groups.
  std::vector<double> influences(const MetricEstimate& estimate) const;
};

/// Throws InputError for values that are not finite; `what` names them.
void check_finite(std::span<const Rgb> values, const std::string& what);

}  // namespace gibench
