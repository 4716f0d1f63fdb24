/// The reason why a process of the program ended without its result, reported to the process that started it.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>

namespace gibench {

enum class ErrorCode {
  bad_input,      ///< the input or the call is wrong
  missing_file,   ///< a file that the input names is found nowhere
  refused,        ///< the method cannot work on the scene
  out_of_memory,  ///< more was asked for than there is
  work_failed,    ///< anything else: out of time, no convergence, cancelled
};
inline constexpr std::array all_error_codes{ErrorCode::bad_input, ErrorCode::missing_file, ErrorCode::refused,
                                            ErrorCode::out_of_memory, ErrorCode::work_failed};
/// "bad_input", "missing_file", …
const char* to_string(ErrorCode code);

struct ErrorRecord {
  ErrorCode code = ErrorCode::work_failed;
  std::string message;  ///< one line
};

/// Name of the environment variable with the file in which a process that was started by another reports its error.
inline constexpr const char* error_file_variable = "GIBENCH_ERROR_FILE";

void write_error_record(const std::filesystem::path& file, const ErrorRecord& record);
/// Empty where the file is absent or damaged: the process ended before it could report it.
std::optional<ErrorRecord> read_error_record(const std::filesystem::path& file);

}  // namespace gibench
