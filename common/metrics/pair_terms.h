/// Differences between the errors of two methods on the same reference, with intervals.
///
/// Both errors move with the same replicates and were taken at the same points, so that most of what makes each of them uncertain
/// is the same in both and leaves their difference. With the influences d_k of the replicates and the parts p_i of the points
/// (intervals.h), those of a difference are the differences of those: the paired jackknife over replicates and over points.
///
/// Taken of the mean squared error T = mean (x−A)(x−B) alone, and of its roots. T_a − T_b is linear in the reference: the noise
/// of the reference times itself, which fireflies make large, cancels exactly, and what is left has no bias. A weight 1/(r² + c)
/// with noise in r has one, which an interval of many points would take for a difference, and the reference's noise makes mape,
/// max and the metrics of pictures larger.
#pragma once

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
  double value = 0.0;              ///< mean squared error: may be below 0
  std::vector<double> influences;  ///< of the replicates
  std::vector<float> parts;        ///< of groups of points: their mean is the value
  std::vector<double> seeds;       ///< the value with each seed of the method; one: not varied
  double point_noise = 0.0;        ///< of the variance over points, what the seeds make (seeded_estimate.h)
  double mean = 0.0;               ///< M of the reference, for relative errors
};

/// Groups of points, at random, that parts are kept of: as many as points where there are fewer.
inline constexpr std::size_t most_pair_parts = 1024;

/// Whether differences of the metric are taken: rmse and relative_rmse.
bool can_be_paired(const std::string& metric);

/// `values` are a method's, one vector for each of its seeds. Throws InputError as value_errors.
PairTerms pair_terms(std::span<const std::vector<Rgb>> values, const Replicas& reference);

/// Error a minus error b.
struct PairedDifference {
  double value = 0.0;
  Interval interval;  ///< 95%
  /// Whether the interval leaves out zero: one of the two is the better one.
  bool told_apart() const { return interval.low > 0.0 || interval.high < 0.0; }
};

/// Of rmse the difference of the squares over the sum of the roots, of relative_rmse that over M; the interval is divided
/// likewise, so that its sign and whether they are told apart are those of the squares. Empty for other metrics, and of relative
/// errors where M is not positive. CheckFailed for terms of another shape: other points or replicates.
std::optional<PairedDifference> difference_of(const std::string& metric, const PairTerms& a, const PairTerms& b);

/// Of the squares.
PairedDifference difference_of_squares(const PairTerms& a, const PairTerms& b);

}  // namespace gibench
