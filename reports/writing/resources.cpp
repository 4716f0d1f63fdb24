#include "reports/writing/resources.h"

#include <cstdlib>

namespace gibench::report {

std::filesystem::path resources_folder() {
  const char* named = std::getenv("GIBENCH_REPORTS");
  return named && *named ? std::filesystem::path(named) : std::filesystem::path(GIBENCH_REPORTS_FOLDER);
}

}  // namespace gibench::report
