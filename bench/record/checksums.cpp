#include "bench/record/checksums.h"

#include "bench/record/json_fields.h"
#include "common/core/atomic_file.h"
#include "common/core/hash.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;
constexpr const char* seal_key = "checksum";

std::string seal_text(Json record) {
  record.erase(seal_key);
  return checksum_of(record.dump(-1, ' ', false, Json::error_handler_t::replace));
}

/// What is wrong with a file; empty where nothing is.
std::string problem_of(const fs::path& file, const std::string& checksum) {
  std::error_code unreadable;
  if (!fs::exists(file, unreadable)) return "is missing";
  if (!fs::is_regular_file(file, unreadable)) return "is not a file";
  try {
    return checksum_of(read_file(file)) == checksum ? "" : "is not as it was written";
  } catch (const InputError&) {
    return "cannot be read";
  }
}

}  // namespace

std::string checksum_of(std::string_view bytes) { return KeyBuilder().add(bytes).hex(); }

FileChecksums checksums_of(const fs::path& folder, const std::set<std::string>& without) {
  FileChecksums checksums;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_regular_file() && !without.contains(name)) checksums[name] = checksum_of(read_file(entry.path()));
  }
  return checksums;
}

std::vector<DamagedFile> damaged_files(const fs::path& folder, const FileChecksums& files) {
  std::vector<DamagedFile> damaged;
  for (const auto& [name, checksum] : files)
    if (const std::string problem = problem_of(folder / name, checksum); !problem.empty()) damaged.push_back({name, problem});
  return damaged;
}

nlohmann::ordered_json to_json(const FileChecksums& files) {
  Json json = Json::object();
  for (const auto& [name, checksum] : files) json[name] = checksum;
  return json;
}

FileChecksums file_checksums_of(const nlohmann::ordered_json& json) {
  FileChecksums files;
  for (const auto& [name, checksum] : json.items()) {
    if (fs::path(name).filename() != name) throw InputError("files", "has a name that is not one of a file");
    files[name] = checksum.get<std::string>();
  }
  return files;
}

void seal(nlohmann::ordered_json& record) { record[seal_key] = seal_text(record); }

Seal seal_of(const nlohmann::ordered_json& record) {
  const Json* checksum = field(record, seal_key);
  if (!checksum) return Seal::none;
  return *checksum == seal_text(record) ? Seal::fits : Seal::broken;
}

}  // namespace gibench
