#include "common/method/stage_report.h"

namespace gibench {

const char* to_string(Termination t) {
  switch (t) {
    case Termination::done: return "done";
    case Termination::converged: return "converged";
    case Termination::bound_reached: return "bound reached";
    case Termination::not_converged: return "not converged";
    case Termination::out_of_budget: return "out of budget";
    case Termination::cancelled: return "cancelled";
    case Termination::invalid_output: return "invalid output";
  }
  return "unknown";
}

}  // namespace gibench
