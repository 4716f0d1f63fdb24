#include "reports/writing/write_report.h"

#include <algorithm>
#include <cerrno>
#include <fstream>

#include "common/core/error.h"
#include "common/core/write_failure.h"
#include "reports/collect/facts.h"
#include "reports/tables/at_a_glance.h"
#include "reports/tables/pair_tables.h"
#include "reports/tables/study_tables.h"
#include "reports/writing/page_data.h"
#include "reports/writing/render_plots.h"
#include "reports/writing/resources.h"

namespace gibench::report {
namespace {

namespace fs = std::filesystem;

void write_text(const fs::path& file, const std::string& text) {
  fs::create_directories(file.parent_path());
  std::ofstream out(file, std::ios::binary);
  out << text;
  if (!out.flush()) throw_write_failure(file, "cannot be written", errno, "choose another --out");
}

void write_table(const fs::path& folder, const Table& table) {
  write_text(folder / (table.name + ".csv"), to_csv(table));
  write_text(folder / (table.name + ".md"), to_markdown(table));
  write_text(folder / (table.name + ".tex"), to_latex(table));
}

void write_tables(const Study& study, const fs::path& folder) {
  const std::vector<ErrorKey> keys = measured_keys(study);
  const ErrorKey key = keys.empty() ? usual_key() : keys.front();
  for (std::size_t scene = 0; scene < study.scenes.size(); ++scene) {
    write_table(folder, scene_table(study, scene, key));
    if (const Table pairs = pair_table(study, scene, key); !pairs.rows.empty()) write_table(folder, pairs);
  }
  write_table(folder, glance_table(study, key, glance_rows(study, key)));
  write_table(folder, ranking_table(study, key, rank(study, key)));
  for (const Table& table :
       {run_table(study), error_table(study), effect_matrix(study), effect_table(study), failure_table(study), call_table(study),
        evidence_table(study), split_table(study, key), bounce_table(study, key)})
    write_table(folder, table);
  if (study.relights.empty()) return;
  write_table(folder, relight_table(study));
  write_table(folder, relit_frame_table(study));
}

std::string read_text(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in)
    throw InputError(file.string(), "is missing",
                     "keep share/gibench beside the program's bin folder whole, or set GIBENCH_REPORTS");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Copies the browser builds of the plot libraries with their licences and gives the script elements that load them;
/// empty, and a page without plots, where they are not installed.
std::string copy_plot_libraries(const fs::path& assets) {
  const fs::path modules = resources_folder() / "node_modules";
  std::string scripts;
  for (const std::string name : {"vega", "vega-lite", "vega-embed"}) {
    const fs::path build = modules / name / "build" / (name + ".min.js");
    if (!fs::exists(build)) return {};
    write_text(assets / (name + ".min.js"), read_text(build));
    write_text(assets / (name + ".LICENSE.txt"), read_text(modules / name / "LICENSE"));
    scripts += "<script src=\"assets/" + name + ".min.js\"></script>\n";
  }
  return scripts;
}

std::string replaced(std::string text, const std::string& mark, const std::string& by) {
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + by.size()))
    text.replace(at, mark.size(), by);
  return text;
}

/// index.html with the study's name in its title; the rest of its text comes with the data.
void write_page(const Study& study, const fs::path& folder) {
  const fs::path page = resources_folder() / "page";
  for (const auto& entry : fs::directory_iterator(page))
    if (entry.path().filename() != "index.html") write_text(folder / "assets" / entry.path().filename(), read_text(entry.path()));
  std::string html = replaced(read_text(page / "index.html"), "{{plot_libraries}}", copy_plot_libraries(folder / "assets"));
  write_text(folder / "index.html", replaced(std::move(html), "{{title}}", escape_html(study.name)));
}

/// The first error's part stands in the study's file: the page opens with it.
void write_data(const Study& study, const std::vector<std::vector<PagePicture>>& pictures,
                const std::vector<std::string>& warnings, const fs::path& folder, const MayGoOn& may_go_on) {
  std::vector<ErrorKey> keys = measured_keys(study);
  if (keys.empty()) keys.push_back(usual_key());
  write_text(folder / "study.js", page_data(study, pictures, warnings) + error_data(study, keys.front(), 0));
  for (std::size_t key = 1; key < keys.size(); ++key) {
    may_go_on();
    write_text(folder / ("error-" + std::to_string(key) + ".js"), error_data(study, keys[key], key));
  }
}

/// Tells the page which plot files there are.
void list_plot_files(const fs::path& folder) {
  std::vector<std::string> names;
  if (fs::exists(folder / "plots"))
    for (const auto& entry : fs::directory_iterator(folder / "plots")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  write_text(folder / "data" / "plot-files.js", "gibench.plotFiles = " + Json(names).dump() + ";\n");
}

}  // namespace

std::vector<std::string> write_report(const Study& study, const fs::path& folder, const MayGoOn& may_go_on) {
  write_text(folder / report_marker, Json{{"gibench_report", 1}, {"study", study.name}, {"commit", study.commit}}.dump(
                                         2, ' ', false, Json::error_handler_t::replace) +
                                         "\n");
  std::vector<std::string> warnings = study.warnings;
  std::vector<std::vector<PagePicture>> pictures;
  for (std::size_t scene = 0; scene < study.scenes.size(); ++scene) {
    may_go_on();
    pictures.push_back(write_pictures(study, scene, folder / "data", warnings));
  }
  may_go_on();
  write_tables(study, folder / "tables");
  write_page(study, folder);
  write_text(folder / "data" / "plots.js", plot_templates(resources_folder() / "plots"));
  write_data(study, pictures, warnings, folder / "data", may_go_on);
  may_go_on();
  fs::create_directories(folder / "plots");
  for (std::string& line : render_plots(folder)) warnings.push_back(std::move(line));
  list_plot_files(folder);
  return warnings;
}

}  // namespace gibench::report
