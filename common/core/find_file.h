/// Where a file that a scene or the command line names is found.
#pragma once

#include <filesystem>
#include <string>

namespace gibench {

/// An absolute path as it is; a relative one looked up in `folder`, then under each folder of GIBENCH_PATH
/// (separated by colons). Throws InputError at `place` with the folders searched.
std::filesystem::path find_file(const std::filesystem::path& file, const std::filesystem::path& folder, const std::string& place);

}  // namespace gibench
