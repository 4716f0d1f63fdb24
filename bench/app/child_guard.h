/// The bond between a process and the children that it started: one that is killed leaves no orphans behind.
#pragma once

#include "bench/record/error_record.h"

namespace gibench {

/// In a child of a study, or one that reads a model: ends this process with SIGKILL when its parent ends. Elsewhere nothing.
void die_with_parent();

/// In a child of a study: reports to the study why this process ends without a result. Elsewhere nothing.
void tell_parent(const ErrorRecord& error);

}  // namespace gibench
