#include "common/core/data_folder.h"

#include <cstdlib>
#include <system_error>

namespace gibench {

namespace fs = std::filesystem;

fs::path program_folder() {
  std::error_code unreadable;
  const fs::path program = fs::read_symlink("/proc/self/exe", unreadable);
  return unreadable ? fs::current_path() : program.parent_path();
}

fs::path data_folder() {
  const char* const named = std::getenv("GIBENCH_DATA");
  return named && *named ? fs::path(named) : (program_folder() / "../share/gibench").lexically_normal();
}

}  // namespace gibench
