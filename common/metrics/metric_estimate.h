/// The parts of a reference that metrics are taken against, and the estimate of one.
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"

namespace gibench {

/// The mean of the reference, its halves, and the means of groups of its replicates, which are independent: one group for a
/// reference without noise, none where they are too few for weights.
struct ReferenceMeans {
  std::span<const Rgb> mean, half_a, half_b;
  std::vector<std::span<const Rgb>> groups;
  static ReferenceMeans exact(std::span<const Rgb> values) { return {values, values, values, {values}}; }
};

/// A metric with its derivative by the reference, from which its interval follows.
struct MetricEstimate {
  double value = 0.0;
  std::vector<Rgb> slope;     ///< 3 n ∂value/∂r at every value and channel
  std::vector<double> parts;  ///< of every value, to first order: their mean is the value; empty for a maximum
  /// The value without each of the groups; empty: the slopes say how it moves with them. With fireflies they do not where a
  /// weight of the mean holds the firefly, and the weight that it had in the value does not.
  std::vector<double> without_group = {};
  double correction = 0.0;   ///< what was added for the noise in weights; as much may still be wrong
  double least_share = 1.0;  ///< of the value: what is left of it with the light of fireflies that the weights do not know
};

}  // namespace gibench
