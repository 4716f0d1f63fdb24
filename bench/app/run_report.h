/// `gibench report`: a study folder made into a web page that opens from disk, tables and plots.
#pragma once

#include <filesystem>

namespace gibench {

/// Reads the manifest, the run records and the pictures of a study folder and writes the report folder: index.html
/// with its data and assets, tables/ as CSV, Markdown and LaTeX, plots/ as SVG and PDF. An empty `out` is
/// study_folder/report. A report that gibench made before is replaced; the new one is built beside it and then
/// renamed. A damaged run is shown as a failed run, with a warning. Without Node.js the plots' files are left out,
/// with one warning line. `quiet` leaves out the closing line, not the warnings.
/// Returns the report folder. Throws InputError for a folder without a study and for an `out` that holds anything but a report.
std::filesystem::path run_report(const std::filesystem::path& study_folder, const std::filesystem::path& out, bool quiet);

}  // namespace gibench
