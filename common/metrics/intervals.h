/// 95% intervals over the replicates of a reference and the choice of points.
///
/// A metric T is a function of the replicates r_1 … r_R, which are independent and alike. Its interval is Student's,
/// T ± t(0.975, R−1) s, with s² = Σ d_k² / (R (R−1)), where d_k is the influence of replicate k: d_k = ∇T · (r_k − r̄)
/// at the mean r̄ (the infinitesimal jackknife), or (R−1) (T̄₍₋₎ − T₍₋ₖ₎) from the values without replicate k (the
/// delete-one jackknife), which are the same to first order.
///
/// For the squared error T = ⟨x−A, x−B⟩ of the halves A and B this is not only asymptotic. With e = x − μ and replicate
/// covariance Σ, Var T = 4 e'Σe/R + 4 tr Σ²/R². The delete-one jackknife of T itself counts the second term twice, as
/// it is degenerate in each half, and has but R−2 degrees of freedom. The influence d_k = −2 ⟨r_k − r̄, x − r̄⟩ has for
/// normal replicates E[s²] = (4/R) E[⟨r_k − r̄, x − r̄⟩²] R/(R−1) = 4 e'Σe/R + 4 tr Σ²/R²: the variance of T exactly,
/// from R−1 degrees of freedom, for every even R.
///
/// The points where values are compared are drawn as well. With p_i the part of point i, so that T is their mean to first
/// order, s_p² = Σ (p_i − T)² / (n (n−1)) is the variance of T over points and, since the noise of different points is
/// independent, over replicates too. s² sees the latter alone, but also noise that points share: the larger of the two counts.
#pragma once

#include <span>
#include <vector>

#include "common/core/rgb.h"
#include "common/metrics/replicas.h"

namespace gibench {

/// Both ends of an interval, included.
struct Interval {
  double low = 0.0, high = 0.0;
};

/// value ± t(0.975, R−1) s from the influences of R ≥ 2 replicates, whose mean is taken off.
Interval student_interval(double value, std::span<const double> influences);

/// The same with the parts of the points; without them as above. `seed_noise` is what of the variance over points is counted
/// elsewhere (seeded_estimate.h).
Interval interval_over_points(double value, std::span<const double> influences, std::span<const double> parts,
                              double seed_noise = 0.0);

/// Where as much as `correction` may be wrong by either sign, and of the value no more than least_share may be left.
Interval with_weights(const Interval& interval, double correction, double least_share);

/// Standard error s of the same.
double standard_error(std::span<const double> influences);

/// d_k of a metric whose derivative by reference value i and its channel is slope[i] / (3 n), at the mean of the replicates.
std::vector<double> slope_influences(std::span<const Rgb> slope, const Replicas& reference, std::span<const Rgb> mean);

/// d_k from the values of a metric without replicate (or group) k.
std::vector<double> delete_one_influences(std::span<const double> values_without);

}  // namespace gibench
