/// Estimates of a metric over the seeds of a method.
///
/// A method's answer may depend on its seed. With T_1 … T_N from N independent seeds against one reference at the same points,
/// the error of the method is their mean, and s² = Σ (T_k − T̄)² / (N (N−1)) what the seeds add to its variance: a source of its
/// own beside the reference and the points. Ends of intervals of independent sources add as squares (Zou and Donner 2008).
///
/// Noise of the method that is independent between points is in the spread of the parts p_i over points already, as
/// V = Σ (p_ik − p̄_i − T_k + T̄)² / (N n (n−1) (N−1)), the interaction of points and seeds. It is taken off there, so that it
/// counts once.
#pragma once

#include <span>
#include <vector>

#include "common/metrics/intervals.h"
#include "common/metrics/value_metrics.h"

namespace gibench {

/// A metric's mean over seeds, and what says how it varies with them.
struct SeededEstimate {
  MetricEstimate mean;         ///< of value, slope, parts and correction alike
  std::vector<double> values;  ///< one for each seed
  double point_noise = 0.0;    ///< V: of the variance over points, what the seeds make; 0 for one seed
};

/// Of one estimate for each seed, one at least.
SeededEstimate over_seeds(std::vector<MetricEstimate> estimates);

/// t(0.975, N−1) s of the values of N seeds; 0 for one seed, whose spread is not known.
double seed_reach(std::span<const double> values);

/// An interval of `value` with its ends moved out by an independent source of the same confidence.
Interval widened(const Interval& interval, double value, double reach);

}  // namespace gibench
