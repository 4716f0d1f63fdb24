/// Approximates a function in the basis, adaptively: the receiver side of COMPUTE-BOUNCE (Lehtinen et al. 2007,
/// section 6.3), for a bounce of light as for direct light.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/meshless/coefficients.h"

namespace gibench::meshless {

/// Computes the function at basis points: values[i] at points[i]. May run on all threads of the task.
using PointValues = std::function<void(std::span<const std::uint32_t> points, std::span<Rgb> values)>;

struct RefinementRule {
  double epsilon_e = 0.0;  ///< share of the reference value
  Rgb solution_mean;       ///< mean over the coarsest samples of what was accumulated before this bounce
};

/// The coefficients of a function (Eq. 10), refined from coarse to fine. All functions of level 0 are computed
/// first. RECEIVER-ORACLE: a coarsest function is refined where its value differs from that of another one which
/// covers its point by more than epsilon_e times the reference, a finer one where its coefficient is larger than
/// that in magnitude, the largest channel deciding. The reference is the mean over the coarsest samples of this
/// function plus rule.solution_mean, averaged over the channels. Refining computes the functions of the next level that cover the
/// point and, before them, every coarser one that covers theirs (their parents).
Coefficients approximate(const Hierarchy& hierarchy, const PointValues& values, const RefinementRule& rule, Task& task);

/// Mean over the coarsest samples, which lie uniformly by area.
RgbDouble coarsest_mean(const Coefficients& coefficients);

}  // namespace gibench::meshless
