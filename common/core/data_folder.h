/// The folder of the files that the program reads at run time: scenes, schemas, the report's page.
#pragma once

#include <filesystem>

namespace gibench {

/// The folder of the running program, links resolved.
std::filesystem::path program_folder();

/// `../share/gibench` seen from the program, in the build folder as in an installed tree; the environment variable
/// GIBENCH_DATA names another one. It holds scenes/, generated_scenes/ and reports/. Not checked to exist.
std::filesystem::path data_folder();

}  // namespace gibench
