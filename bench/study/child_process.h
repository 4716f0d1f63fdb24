/// Child processes under limits: how each ended, what it cost.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "bench/record/error_record.h"

namespace gibench {

/// Name of the environment variable that gives children the process id of their parent.
inline constexpr const char* parent_variable = "GIBENCH_STUDY_PROCESS";

struct ChildLimits {
  std::optional<double> seconds;       ///< wall clock
  std::optional<std::uint64_t> bytes;  ///< resident memory
};

enum class ChildEnd {
  exited,
  signalled,    ///< ended by a signal that was not ours
  timed_out,    ///< killed at its time limit
  over_memory,  ///< killed at its memory limit
  cancelled,    ///< the user asked to stop
};

struct ChildResult {
  ChildEnd end = ChildEnd::exited;
  int exit_code = 0;
  int signal = 0;
  double seconds = 0.0;              ///< wall clock
  std::uint64_t peak_bytes = 0;      ///< largest resident memory
  std::string out, last_line;        ///< all of stdout, the last line of stderr
  std::optional<ErrorRecord> error;  ///< why it ended without a result, where it could report it
};

/// Where a child's stdout, stderr and its error go.
struct ChildFiles {
  std::filesystem::path out, error;
  std::filesystem::path error_record;  ///< empty: the child is not asked for it
};

/// Runs this program with the arguments and waits for it. Throws WorkError where no process can be made. A killed parent takes
/// the child with it.
ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits, const ChildFiles& files);
/// The same with files of this name in `scratch`, which must exist.
ChildResult run_child(const std::vector<std::string>& arguments, const ChildLimits& limits, const std::filesystem::path& scratch,
                      const std::string& name);

/// "Segmentation fault", "CPU time limit exceeded", …
std::string describe_signal(int signal);

}  // namespace gibench
