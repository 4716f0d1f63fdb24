/// The page, the plot templates and the packages that the report is made with.
#pragma once

#include <filesystem>

namespace gibench::report {

/// The reports/ folder of the sources, or the folder that the environment variable GIBENCH_REPORTS names.
std::filesystem::path resources_folder();

}  // namespace gibench::report
