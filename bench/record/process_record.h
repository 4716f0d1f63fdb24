/// The end of the process of a run in a study: run.json beside the run's result.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "bench/record/checksums.h"
#include "bench/record/error_record.h"

namespace gibench {

enum class RunStatus { done, refused, timed_out, crashed, failed, skipped };
inline constexpr std::array all_run_statuses{RunStatus::done,    RunStatus::refused, RunStatus::timed_out,
                                             RunStatus::crashed, RunStatus::failed,  RunStatus::skipped};
/// As in the files: "done", "timed_out", …
const char* to_string(RunStatus status);

inline constexpr const char* process_file = "run.json";

struct ProcessRecord {
  std::string key;  ///< of what was asked: under another key the result is out of date
  RunStatus status = RunStatus::failed;
  std::optional<int> exit_code;             ///< of a process that was not killed
  std::optional<ErrorCode> error;           ///< why it ended without a result, where it could report it
  std::string message;                      ///< the same in words; empty for one that came to its end
  std::optional<double> wall_seconds;       ///< of the whole process
  std::optional<std::uint64_t> peak_bytes;  ///< of the work, as its record says, else of the process
  std::optional<std::uint64_t> process_peak_bytes;
  std::optional<std::string> reference;       ///< state of the one that errors were taken against; empty: none
  std::optional<std::string> path_reference;  ///< of the one of the method's light paths
  FileChecksums files;                        ///< of what the run left, the log and this record excepted
};

/// With a checksum of its own.
nlohmann::ordered_json to_json(const ProcessRecord& record);
/// Adds to a manifest's entry what the record says, without the key.
void add_to_entry(const ProcessRecord& record, nlohmann::ordered_json& entry);
/// What a manifest's entry says of its process; an unknown status is read as failed, with a message.
ProcessRecord process_of_entry(const nlohmann::ordered_json& entry);
/// Empty where the file is absent, damaged or without its checksum.
std::optional<ProcessRecord> read_process_record(const std::filesystem::path& file);

}  // namespace gibench
