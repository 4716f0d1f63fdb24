#include "bench/app/run_report.h"

#include <fmt/format.h>

#include <cstdio>

#include "bench/measure/cancellation.h"
#include "bench/record/output_folder.h"
#include "common/core/printable_text.h"
#include "reports/collect/collect.h"
#include "reports/writing/write_report.h"

namespace gibench {

std::filesystem::path run_report(const std::filesystem::path& study_folder, const std::filesystem::path& out, bool quiet) {
  const report::Study study = report::collect_study(study_folder, stop_if_cancelled);
  const std::filesystem::path target = out.empty() ? study_folder / "report" : out;
  OutputFolder output(target, report::report_marker, true);
  for (const std::string& warning : report::write_report(study, output.partial(), stop_if_cancelled))
    fmt::print(stderr, "gibench: warning: {}\n", printable_text(warning));
  output.commit();
  if (!quiet) fmt::print("report: {}\n", (target / "index.html").string());
  return target;
}

}  // namespace gibench
