#include "bench/record/error_record.h"

#include "bench/record/json_fields.h"
#include "common/core/atomic_file.h"
#include "common/core/enum_names.h"

namespace gibench {

const char* to_string(ErrorCode code) {
  switch (code) {
    case ErrorCode::bad_input: return "bad_input";
    case ErrorCode::missing_file: return "missing_file";
    case ErrorCode::refused: return "refused";
    case ErrorCode::out_of_memory: return "out_of_memory";
    case ErrorCode::work_failed: return "work_failed";
  }
  return "work_failed";
}

void write_error_record(const std::filesystem::path& file, const ErrorRecord& record) {
  const Json json{{"error", to_string(record.code)}, {"message", record.message}};
  write_file_atomically(file, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

std::optional<ErrorRecord> read_error_record(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  const Json json = Json::parse(read_file(file), nullptr, false);
  const Json *name = field(json, "error"), *message = field(json, "message");
  if (!name || !name->is_string() || !message || !message->is_string()) return std::nullopt;
  const auto code = find_named(all_error_codes, name->get<std::string>());
  return code ? std::optional(ErrorRecord{*code, message->get<std::string>()}) : std::nullopt;
}

}  // namespace gibench
