/// Checksums of result files and of records, by which damage is seen.
#pragma once

#include <filesystem>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gibench {

/// By the names of the files in one folder: XXH3 of their bytes, 32 hex digits.
using FileChecksums = std::map<std::string, std::string>;

std::string checksum_of(std::string_view bytes);

/// Of every file that lies directly in the folder, but for those of these names. Throws InputError for one that cannot be read.
FileChecksums checksums_of(const std::filesystem::path& folder, const std::set<std::string>& without);

/// A file that is not as it was written.
struct DamagedFile {
  std::string name;
  std::string problem;  ///< "is missing", "is not as it was written", …
};
/// Those of the files that are damaged, in the order of their names.
std::vector<DamagedFile> damaged_files(const std::filesystem::path& folder, const FileChecksums& files);

nlohmann::ordered_json to_json(const FileChecksums& files);
/// Throws InputError for a name that leads out of the folder.
FileChecksums file_checksums_of(const nlohmann::ordered_json& json);

/// Adds to a record its own checksum, as "checksum".
void seal(nlohmann::ordered_json& record);
enum class Seal { none, fits, broken };
/// Whether a record is as it was sealed.
Seal seal_of(const nlohmann::ordered_json& record);

}  // namespace gibench
