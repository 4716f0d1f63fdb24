/// The bond between a study and its runs: a killed study leaves no orphans behind.
#pragma once

namespace gibench {

/// Name of the environment variable with which a study tells its children its process id.
inline constexpr const char* parent_variable = "GIBENCH_STUDY_PROCESS";

/// In a child of a study: ends this process with SIGKILL when the study ends. Elsewhere nothing.
void die_with_parent_study();

}  // namespace gibench
