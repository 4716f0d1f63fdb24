/// The report of a stage of a method: how it ended and why, what it took.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "common/core/counters.h"

namespace gibench {

/// How a stage ended.
enum class Termination {
  done,            ///< a direct computation came to its end
  converged,       ///< an iteration met its tolerance
  bound_reached,   ///< an iteration met its planned bound (bounces, iterations) before its tolerance
  not_converged,   ///< an iteration stopped without success; the message says what was tried
  out_of_budget,   ///< memory or time ran out; the message names the parameter
  cancelled,       ///< asked to stop
  invalid_output,  ///< a value was not written or is not finite
};

inline constexpr std::array all_terminations{Termination::done,          Termination::converged,     Termination::bound_reached,
                                             Termination::not_converged, Termination::out_of_budget, Termination::cancelled,
                                             Termination::invalid_output};

/// Whether the answer of the stage may be used.
constexpr bool succeeded(Termination t) {
  return t == Termination::done || t == Termination::converged || t == Termination::bound_reached;
}
const char* to_string(Termination t);

/// The progress of a stage at one moment.
struct ProgressPoint {
  std::string step;
  double done = 0.0;       ///< share of the stage, [0, 1]
  double residual = -1.0;  ///< relative residual of an iteration; negative where there is none
};

/// What a stage did; numerics report their outcome here and never throw.
struct StageReport {
  Termination termination = Termination::done;
  std::string message;
  double seconds = 0.0;  ///< wall clock
  Counters counters;     ///< what this stage added, rays included
  std::vector<ProgressPoint> history;
};

}  // namespace gibench
