#include "bench/study/child_outcome.h"

#include <fmt/format.h>

namespace gibench {

bool succeeded(const ChildResult& child) { return child.end == ChildEnd::exited && child.exit_code == 0; }

bool ended_with(const ChildResult& child, ErrorCode code) {
  return child.end == ChildEnd::exited && child.error && child.error->code == code;
}

RunStatus status_of(const ChildResult& child) {
  switch (child.end) {
    case ChildEnd::timed_out: return RunStatus::timed_out;
    case ChildEnd::signalled: return RunStatus::crashed;
    case ChildEnd::over_memory:
    case ChildEnd::cancelled: return RunStatus::failed;
    case ChildEnd::exited: break;
  }
  if (child.exit_code == 0) return RunStatus::done;
  return ended_with(child, ErrorCode::refused) ? RunStatus::refused : RunStatus::failed;
}

std::string reason_of(const ChildResult& child, const ChildLimits& limits) {
  switch (child.end) {
    case ChildEnd::timed_out: return fmt::format("stopped at its time limit of {} s", *limits.seconds);
    case ChildEnd::over_memory:
      return fmt::format("stopped at its memory limit of {} MB", static_cast<double>(*limits.bytes) / (1024.0 * 1024.0));
    case ChildEnd::signalled:
      return fmt::format("ended by a signal: {}{}{}", describe_signal(child.signal), child.last_line.empty() ? "" : "; ",
                         child.last_line);
    case ChildEnd::cancelled: return "cancelled";
    case ChildEnd::exited: break;
  }
  if (child.exit_code == 0) return {};
  return child.error ? child.error->message : child.last_line;
}

}  // namespace gibench
