/// Folders that appear or are replaced as a whole.
#pragma once

#include <filesystem>

namespace gibench {

/// Makes `made`, a whole folder beside `target`, the folder `target`. An old one is exchanged for it in one step where
/// the file system can (renameat2), else moved to previous_version(target) for the moment between two renames; then it is
/// removed. If that fails it throws with the system's reason: WorkError for a full disk, else InputError.
void replace_folder(const std::filesystem::path& made, const std::filesystem::path& target);

/// Where the old folder is while a file system without an exchange replaces it.
std::filesystem::path previous_version(const std::filesystem::path& target);

/// `target`, or previous_version(target) where a killed replacement left only that.
std::filesystem::path existing_version(const std::filesystem::path& target);

}  // namespace gibench
