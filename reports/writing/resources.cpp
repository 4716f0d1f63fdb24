#include "reports/writing/resources.h"

#include <cstdlib>

#include "common/core/data_folder.h"

namespace gibench::report {

std::filesystem::path resources_folder() {
  const char* named = std::getenv("GIBENCH_REPORTS");
  return named && *named ? std::filesystem::path(named) : data_folder() / "reports";
}

}  // namespace gibench::report
