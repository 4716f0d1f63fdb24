/// The bond between a study and its runs: a killed study leaves no orphans behind.
#pragma once

#include "bench/record/error_record.h"

namespace gibench {

/// In a child of a study: ends this process with SIGKILL when the study ends. Elsewhere nothing.
void die_with_parent_study();

/// In a child of a study: reports to the study why this process ends without a result. Elsewhere nothing.
void tell_parent(const ErrorRecord& error);

}  // namespace gibench
