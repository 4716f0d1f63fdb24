/// Differences between the errors of two methods on the same reference, with intervals.
///
/// Both errors move with the same replicates and were taken at the same points, so that most of what makes each of them uncertain
/// is the same in both and leaves their difference. With the influences d_k of the replicates and the parts p_i of the points
/// (intervals.h), those of a difference are the differences of those: the paired jackknife over replicates and over points.
///
/// Taken of the mean squared error T = mean (x−A)(x−B), of its roots, and of rel_mse(0.01), whose terms have weights from other
/// replicates than A and B. T_a − T_b is linear in A and B: the noise of the reference times itself, which fireflies make large,
/// cancels exactly. The weights are the same in both; what the correction for their noise moves the difference by widens its
/// interval (weighted_metrics.h).
///
/// Of mape, smape and rel_mse_trim only two bounds can be estimated. Their difference is known from the least of one minus the
/// most of the other on, which says no more than the two intervals. The reference's noise makes max and the metrics of pictures
/// larger, by more where the error is smaller.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "common/core/rgb.h"
#include "common/metrics/intervals.h"
#include "common/metrics/replicas.h"

namespace gibench {

/// What one error brings into a difference.
struct PairTerms {
  double value = 0.0;              ///< mean squared error or rel_mse: may be below 0
  std::vector<double> influences;  ///< of the replicates, or of at most eight groups of them
  std::vector<float> parts;        ///< of groups of points: their mean is the value
  std::vector<double> seeds;       ///< the value with each seed of the method; one: not varied
  double point_noise = 0.0;        ///< of the variance over points, what the seeds make (seeded_estimate.h)
  double mean = 0.0;               ///< M of the reference, for relative errors
  double correction = 0.0;         ///< for the noise in weights, part of the value
  double least_share = 1.0;        ///< of the value, with weights that know all fireflies
};

/// Groups of points, at random, that parts are kept of: as many as points where there are fewer.
inline constexpr std::size_t most_pair_parts = 1024;

/// The metrics that terms are kept of.
inline constexpr std::array paired_metrics{"rmse", "rel_mse(0.01)"};

/// That of paired_metrics by which differences of this metric are taken, of relative_rmse those of rmse; empty: they are not.
std::optional<std::string> paired_by(const std::string& metric);

/// Of a metric of paired_metrics; `values` are a method's, one vector for each of its seeds. Empty where the metric is not
/// defined: fewer than three replicates, a black reference. Throws InputError as value_errors.
std::optional<PairTerms> pair_terms(const std::string& metric, std::span<const std::vector<Rgb>> values,
                                    const Replicas& reference);

/// Error a minus error b.
struct PairedDifference {
  double value = 0.0;
  Interval interval;  ///< 95%
  /// Whether the interval leaves out zero: one of the two is the better one.
  bool told_apart() const { return interval.low > 0.0 || interval.high < 0.0; }
};

/// From terms of paired_by(metric). Of rmse the difference of the squares over the sum of the roots, of relative_rmse that over
/// M; the interval is divided likewise, so that its sign and whether they are told apart are those of the squares. Empty for
/// other metrics, and of relative_rmse where M is not positive. CheckFailed for terms of another shape: other points or
/// replicates.
std::optional<PairedDifference> difference_of(const std::string& metric, const PairTerms& a, const PairTerms& b);

/// Of the terms as they are: squares.
PairedDifference difference_of_squares(const PairTerms& a, const PairTerms& b);

}  // namespace gibench
