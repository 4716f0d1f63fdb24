/// The plots as files, by Node.js from the same Vega-Lite specifications as the page's.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gibench::report {

/// Runs reports/render.mjs on a report folder whose data is written; it adds plots/*.svg, *.pdf and *.vl.json.
/// Returns what is lacking, a line each; empty when every plot was made.
std::vector<std::string> render_plots(const std::filesystem::path& report_folder);

}  // namespace gibench::report
