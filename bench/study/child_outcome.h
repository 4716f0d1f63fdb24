/// The outcome of a child process in the terms of its record: status and reason.
#pragma once

#include <string>

#include "bench/record/process_record.h"
#include "bench/study/child_process.h"

namespace gibench {

/// It came to its end by itself, with its result.
bool succeeded(const ChildResult& child);
/// It ended by itself with this error.
bool ended_with(const ChildResult& child, ErrorCode code);
RunStatus status_of(const ChildResult& child);
/// Why there is no result, one line for people; empty for a child that succeeded. `limits` are those under which it ran.
std::string reason_of(const ChildResult& child, const ChildLimits& limits);

}  // namespace gibench
