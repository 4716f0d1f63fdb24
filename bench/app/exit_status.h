/// The program's exit status.
#pragma once

namespace gibench {

enum class ExitStatus {
  done = 0,
  gate_failed = 1,
  bad_input = 2,  ///< the input or the call is wrong: one line on stderr says what is wrong, where, and how to fix it
  inconclusive = 3,
  work_failed = 4,  ///< out of time or memory, no convergence, cancelled, or a method that refused the scene
};

}  // namespace gibench
