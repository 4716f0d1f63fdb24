/// The Neumann series of indirect light in the basis, b = T b + e (Lehtinen et al. 2007, section 6.3).
#pragma once

#include <optional>
#include <string>

#include "common/finite_elements/bounce_series.h"
#include "common/method/stage_report.h"
#include "common/method/task.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/convergence.h"
#include "methods/meshless/light_at_points.h"

namespace gibench::meshless {

/// What bounds the series.
struct SeriesBound {
  BounceBound bounces;
  bool may_extrapolate = false;

  /// `max_bounces`: of the plan, which bounds nothing where it allows more bounces than are computed.
  SeriesBound(const Settings& settings, const std::optional<int>& max_bounces);
};

/// Indirect light and how its series ended.
struct IndirectLight {
  Coefficients coefficients;
  Termination termination = Termination::done;
  std::string message;
};

/// Every bounce is gathered from the one before and refined over all levels: the paper's COMPUTE-BOUNCE. `direct`: nullptr where
/// direct light is evaluated at the hits of the first gathers.
IndirectLight refined_bounces(LightAtPoints& light, const Transport& transport, const Coefficients* direct,
                              const Settings& settings, const SeriesBound& bound, Task& task);

/// A series of bounces that is being added up.
class BounceSum {
 public:
  BounceSum(Coefficients first, const SeriesBound& bound, double residual, Task& task);

  const Coefficients& last() const { return last_; }
  const Coefficients& sum() const { return sum_; }
  const BounceSeries& series() const { return series_; }
  /// One more bounce; the geometric tail, too, where it is known.
  void add(Coefficients next);
  /// One more bounce that is not part of the sum.
  void add_unsummed() { series_.add(); }

 private:
  bool tail_is_known(const Convergence& state) const;

  bool may_extrapolate_;
  double residual_;
  Task& task_;
  BounceSeries series_;
  Coefficients last_, sum_;
};

}  // namespace gibench::meshless
