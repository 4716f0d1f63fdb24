#include "common/core/find_file.h"

#include <cstdlib>
#include <sstream>
#include <system_error>
#include <vector>

#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

namespace {

namespace fs = std::filesystem;

std::vector<fs::path> folders_to_search(const fs::path& folder) {
  std::vector<fs::path> folders{folder.empty() ? fs::path(".") : folder};
  if (const char* variable = std::getenv("GIBENCH_PATH")) {
    std::istringstream list(variable);
    for (std::string entry; std::getline(list, entry, ':');)
      if (!entry.empty()) folders.emplace_back(entry);
  }
  return folders;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::exists(path, ignored) && !fs::is_directory(path, ignored);
}

}  // namespace

fs::path find_file(const fs::path& file, const fs::path& folder, const std::string& place) {
  if (file.is_absolute()) {
    if (is_file(file)) return file;
    throw InputError(place, "there is no file " + in_quotes(file.string()), "name an existing file");
  }
  std::string searched;
  for (const fs::path& candidate : folders_to_search(folder)) {
    if (is_file(candidate / file)) return candidate == "." ? file : candidate / file;
    searched += (searched.empty() ? "" : ", ") + candidate.string();
  }
  throw MissingFileError(place, "there is no file " + in_quotes(file.string()) + " in " + searched,
                         "correct the name, or add the folder that has it to GIBENCH_PATH");
}

}  // namespace gibench
