/// The writing of the files of a report.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/collect/collect.h"

namespace gibench::report {

/// The file by which a report folder is known to be gibench's own.
inline constexpr const char* report_marker = "report.json";

/// Writes page, tables and plots into an existing, empty folder. Returns what went wrong on the way without stopping
/// it, a line each: damaged records and pictures, plots that could not be made. Throws InputError where the folder
/// cannot be written.
std::vector<std::string> write_report(
    const Study& study, const std::filesystem::path& folder, const MayGoOn& may_go_on = [] {});

}  // namespace gibench::report
