/// The end of a series of bounces, in the terms of a stage report.
#pragma once

#include "common/finite_elements/bounce_series.h"
#include "common/method/stage_report.h"

namespace gibench {

inline Termination termination_of(const BounceSeries& series) {
  if (series.settled()) return Termination::converged;
  return series.succeeded() ? Termination::bound_reached : Termination::not_converged;
}

}  // namespace gibench
