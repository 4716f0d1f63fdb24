#include "bench/record/process_record.h"

#include "bench/record/json_fields.h"
#include "common/core/atomic_file.h"
#include "common/core/enum_names.h"

namespace gibench {

const char* to_string(RunStatus status) {
  switch (status) {
    case RunStatus::done: return "done";
    case RunStatus::refused: return "refused";
    case RunStatus::timed_out: return "timed_out";
    case RunStatus::crashed: return "crashed";
    case RunStatus::failed: return "failed";
    case RunStatus::skipped: return "skipped";
  }
  return "failed";
}

void add_to_entry(const ProcessRecord& record, Json& entry) {
  entry["status"] = to_string(record.status);
  write_field(entry, "exit_code", record.exit_code);
  if (record.error) entry["error"] = to_string(*record.error);
  if (!record.message.empty()) entry["message"] = record.message;
  write_field(entry, "wall_seconds", record.wall_seconds);
  write_field(entry, "peak_bytes", record.peak_bytes);
  write_field(entry, "process_peak_bytes", record.process_peak_bytes);
  write_field(entry, "reference", record.reference);
  write_field(entry, "path_reference", record.path_reference);
  if (!record.files.empty()) entry["files"] = to_json(record.files);
}

Json to_json(const ProcessRecord& record) {
  Json json{{"key", record.key}};
  add_to_entry(record, json);
  seal(json);
  return json;
}

ProcessRecord process_of_entry(const Json& entry) {
  ProcessRecord record;
  std::string status, error;
  read_field(entry, "key", record.key);
  read_field(entry, "status", status);
  read_field(entry, "exit_code", record.exit_code);
  read_field(entry, "error", error);
  read_field(entry, "message", record.message);
  read_field(entry, "wall_seconds", record.wall_seconds);
  read_field(entry, "peak_bytes", record.peak_bytes);
  read_field(entry, "process_peak_bytes", record.process_peak_bytes);
  read_field(entry, "reference", record.reference);
  read_field(entry, "path_reference", record.path_reference);
  record.files = file_checksums_of(object_field(entry, "files"));
  record.error = find_named(all_error_codes, error);
  if (const auto known = find_named(all_run_statuses, status)) record.status = *known;
  else record.message = "unknown status '" + status + "' in the manifest" + (record.message.empty() ? "" : "; " + record.message);
  return record;
}

std::optional<ProcessRecord> read_process_record(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  const Json json = Json::parse(read_file(file), nullptr, false);
  if (!json.is_object() || seal_of(json) != Seal::fits) return std::nullopt;
  try {
    return process_of_entry(json);
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;
  } catch (const InputError&) {
    return std::nullopt;
  }
}

}  // namespace gibench
