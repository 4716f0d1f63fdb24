#include "bench/report.h"

#include <spdlog/spdlog.h>

#include "bench/output_folder.h"
#include "bench/report/collect.h"
#include "bench/report/write_report.h"

namespace gibench {

std::filesystem::path run_report(const std::filesystem::path& study_folder, const std::filesystem::path& out, bool quiet) {
  const report::Study study = report::collect_study(study_folder);
  const std::filesystem::path target = out.empty() ? study_folder / "report" : out;
  OutputFolder output(target, report::report_marker, true);
  for (const std::string& warning : report::write_report(study, output.partial())) spdlog::warn("{}", warning);
  output.commit();
  if (!quiet) spdlog::info("report: {}", (target / "index.html").string());
  return target;
}

}  // namespace gibench
