/// The error metrics whose weights hold the reference, which is itself uncertain.
///
/// A weight w(r) is not a polynomial, and so no estimate from a finite number of replicates has its value at the true μ for a
/// mean: the mean of any function of R replicates that are a firefly with chance p and dark otherwise is a polynomial in p of
/// degree R, while w(μ), as of 1 / (μ² + c), is a fraction. What can be had, and is, with the replicates joined to G ≤ 8 groups
/// r_1 … r_G:
///
/// 1. Weight and error share no noise. (x−r_j)(x−r_k) is weighed by w(m_jk), m_jk the mean of the other G−2 groups, and the mean
///    is taken over all pairs j < k. Its mean is (x−μ)² E[w(m_jk)]: no error stays none, whatever the noise.
/// 2. E[w(m)] = w(μ) + ½ w''(μ) σ²/n + O(n⁻²) of n groups. The jackknife, n w(m) − (n−1) mean_l w(m without l), has no term in
/// 1/n.
///    What it changes is the `correction`, by which intervals are widened on both sides: as much may be left.
/// 3. Fireflies that come at fewer points than one of the replicates has make every other point too dark, which its replicates
///    cannot tell: weights are too large there. All points together can: with light of the share δ in such fireflies, the
///    others are darker by δ, and the halves A and B differ by mean |A−B|/2 = δ M, of which what noise seen at most points makes,
///    as normal noise of the same median has, is taken off. The low end of an interval allows for weights of r / (1−δ).
/// 4. |x−μ| is no polynomial either, but lies between two that can be estimated. With a sign s from other groups
///    E[s (x−r_j)] = (x−μ) E[s] ≤ |x−μ| for any noise, as |E[s]| ≤ 1, and E|x−r_j| ≥ |x−μ| by Jensen's inequality. So there are
///    two estimates, at_least and at_most: the interval goes from the low end of the one to the high end of the other. The
///    value is the root of their product. For errors N(0, τ²) and noise N(0, σ²) in sign and error they are
///    √(2/π) τ² / √(τ²+σ²) and √(2/π) √(τ²+σ²), whose product is that of the truth, √(2/π) τ, squared, at any σ.
/// 5. Without the largest errors a mean is the least one over all choices of those left out. Chosen by the estimated terms
///    themselves it is too small, as E[min] ≤ min E; chosen by other replicates than those of the terms it is too large, as no
///    choice is better than the best. These are its two estimates.
#pragma once

#include <optional>
#include <span>

#include "common/core/rgb.h"
#include "common/metrics/metric_estimate.h"

namespace gibench {

// All are empty where M is not positive, and for fewer than three groups, unless the reference is exact.

/// rel_mse(0.01): mean (x−r)² / (r² + 0.01 M²).
std::optional<MetricEstimate> relative_squared_error(std::span<const Rgb> values, const ReferenceMeans& reference);

/// rel_mse_trim(0.1%): the same without the ⌊n/1000⌋ of the n values whose (x−r)²/(r²+0.01 M²), averaged over the channels, is
/// largest (of equal ones the later go first). Under 1000 values nothing is left out.
std::optional<MetricEstimate> trimmed_relative_squared_error_at_least(std::span<const Rgb> values,
                                                                      const ReferenceMeans& reference);
std::optional<MetricEstimate> trimmed_relative_squared_error_at_most(std::span<const Rgb> values,
                                                                     const ReferenceMeans& reference);

/// mape(0.01): mean |x−r| / (|r| + 0.01 M). At least: sign and weight from all groups but one, x−r_j from that one, over all of
/// them. At most: |x−r| from half of the groups and the weight from the others, both ways.
std::optional<MetricEstimate> percentage_error_at_least(std::span<const Rgb> values, const ReferenceMeans& reference);
std::optional<MetricEstimate> percentage_error_at_most(std::span<const Rgb> values, const ReferenceMeans& reference);

/// smape(0.02): mean 2|x−r| / (|x| + |r| + 0.02 M), likewise.
std::optional<MetricEstimate> symmetric_error_at_least(std::span<const Rgb> values, const ReferenceMeans& reference);
std::optional<MetricEstimate> symmetric_error_at_most(std::span<const Rgb> values, const ReferenceMeans& reference);

}  // namespace gibench
