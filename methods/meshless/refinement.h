/// Adaptive approximation of a function in the basis: the receiver side of COMPUTE-BOUNCE (Lehtinen et al. 2007,
/// section 6.3), for a bounce of light as for direct light.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/gather.h"
#include "methods/meshless/settings.h"

namespace gibench::meshless {

/// Estimates the function at basis points: values[i] at points[i]. May run on all threads of the task.
using PointValues = std::function<void(std::span<const std::uint32_t> points, std::span<Estimate> values)>;

struct RefinementRule {
  double epsilon_e = 0.0;     ///< share of the reference value
  double noise_guard = 0.0;   ///< deviations that a difference must exceed, too, to count as detail
  double proximity = 0.0;     ///< weight of what is near, see approximate()
  double level_growth = 1.0;  ///< of the threshold from level to level
  ThresholdMean threshold_mean = ThresholdMean::area;
  int corrections = 0;           ///< see fit.h
  std::uint32_t full_level = 0;  ///< levels up to this one are computed wholly
  double solution_mean = 0.0;    ///< mean over the coarsest samples of what was accumulated before, W/m²
  double previous_mean = 0.0;    ///< likewise of the term of the series before this one; 0: this is not a series
  int terms_left = 0;            ///< terms of the series still to come
  int channels = 3;              ///< 1: all three are equal
};

/// The coefficients of a function (Eq. 10), refined from coarse to fine. The levels up to full_level are computed
/// first. RECEIVER-ORACLE: a coarsest function is refined where its value differs from that of another one which
/// covers its point by more than epsilon_e times the reference, a finer one where its coefficient is larger than
/// that in magnitude, the largest channel deciding; and by more than noise_guard deviations of the estimates (an
/// addition: the paper's oracle would chase the noise of its gathers to the finest level). Functions whose difference is over
/// epsilon_e, but not over the noise, are not refined; the task counts them as `undecided_samples`: there it is the noise of the
/// estimates, not epsilon_e, that bounds the error. A function is refined, too, where what is near may make irradiance vary by
/// that much within its ball: proximity · radius · the slope of its estimate. On level l all this must exceed level_growth^l
/// times as much: at 1 the largest error is the same on all levels, at 2 the squared error that a function may leave times its
/// area, which is a quarter of its parent's. The reference is the mean irradiance, over the surfaces and the channels, that the
/// whole series is foreseen to come to: solution_mean and this term, and the terms left where they fade as this one did; weighted
/// by irradiance (ΣE² / ΣE, in which dark surfaces do not count) where threshold_mean says so, by this term's share of the one in
/// the other. Refining computes the functions of the next level that cover the point and, before them, every coarser one that
/// covers theirs (their parents).
Coefficients approximate(const Hierarchy& hierarchy, const PointValues& values, const RefinementRule& rule, Task& task);

/// Mean over the surfaces' area, each of the coarsest samples for its share of it.
RgbDouble coarsest_mean(const Coefficients& coefficients);

constexpr double channel_mean(const RgbDouble& value) { return (value.r + value.g + value.b) / 3.0; }

}  // namespace gibench::meshless
