#include "bench/app/child_guard.h"

#include <sys/prctl.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <exception>

#include "bench/study/child_process.h"

namespace gibench {

void die_with_parent() {
  const char* parent = std::getenv(parent_variable);
  if (!parent) return;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (std::atol(parent) != static_cast<long>(getppid())) _exit(137);  // it ended before the line above
}

void tell_parent(const ErrorRecord& error) {
  const char* file = std::getenv(error_file_variable);
  if (!file) return;
  try {
    write_error_record(file, error);
  } catch (const std::exception&) {  // the study then has the exit status and the line on stderr
  }
}

}  // namespace gibench
