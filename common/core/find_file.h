/// The search for a file that a scene or the command line names.
#pragma once

#include <filesystem>
#include <string>

#include "common/core/error.h"

namespace gibench {

/// A file that the input names is found nowhere: on another machine, or with another GIBENCH_PATH, it may be there.
class MissingFileError : public InputError {
 public:
  using InputError::InputError;
};

/// An absolute path as it is; a relative one looked up in `folder`, then under each folder of GIBENCH_PATH
/// (separated by colons). Throws MissingFileError at `place` with the folders searched; InputError for an absolute path
/// that names no file.
std::filesystem::path find_file(const std::filesystem::path& file, const std::filesystem::path& folder, const std::string& place);

}  // namespace gibench
