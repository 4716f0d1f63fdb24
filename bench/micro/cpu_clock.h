/// CPU seconds: unlike the wall clock's, other programs' turns are not among them.
#pragma once

#include <ctime>

namespace gibench::micro {

inline double seconds_on(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Of this thread so far.
inline double thread_seconds() { return seconds_on(CLOCK_THREAD_CPUTIME_ID); }
/// Of all threads of the process so far.
inline double process_seconds() { return seconds_on(CLOCK_PROCESS_CPUTIME_ID); }

}  // namespace gibench::micro
