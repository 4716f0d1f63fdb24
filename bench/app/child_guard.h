/// The bond between a study and its runs: a killed study leaves no orphans behind.
#pragma once

namespace gibench {

/// In a child of a study: ends this process with SIGKILL when the study ends. Elsewhere nothing.
void die_with_parent_study();

}  // namespace gibench
