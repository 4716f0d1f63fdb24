#include "reports/tables/pair_tables.h"

#include <fmt/format.h>

#include "reports/collect/compare_runs.h"
#include "reports/tables/metric_info.h"
#include "reports/tables/standing.h"
#include "reports/tables/study_tables.h"
#include "reports/tables/table_columns.h"

namespace gibench::report {
namespace {

struct PairRow {
  const StudyRun& run;
  const StudyRun& other;
  const Comparison& comparison;

  /// Empty where they are not told apart.
  std::string better() const { return !comparison.told_apart() ? "" : comparison.difference < 0.0 ? run.label : other.label; }
};

}  // namespace

Table pair_table(const Study& study, std::size_t scene, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  Columns<PairRow> columns;
  columns.text("Run", "run", [](const PairRow& row) { return row.run.label; })
      .text("Method", "method", [](const PairRow& row) { return row.run.method; })
      .text("Other run", "other_run", [](const PairRow& row) { return row.other.label; })
      .cells({"Difference [95% interval]", "difference"},
             [&](const PairRow& row) {
               const Comparison& apart = row.comparison;
               return Cell{difference_text(metric, apart.difference, apart.low, apart.high), exact(apart.difference)};
             })
      .in_csv(
          "difference_ci95_low", [](const PairRow& row) { return std::optional(row.comparison.low); }, number_cell)
      .in_csv(
          "difference_ci95_high", [](const PairRow& row) { return std::optional(row.comparison.high); }, number_cell)
      .text("Better", "better", [](const PairRow& row) { return row.better(); });
  std::vector<PairRow> rows;
  for (const Comparison& comparison : comparisons_of(study, scene, key))
    rows.push_back({study.runs[comparison.run], study.runs[comparison.other], comparison});
  return columns.table(
      scene_slug(study, scene) + "-pairs",
      fmt::format("{}: {} of {}, every two of the {} most accurate runs on the same reference: the first one's error minus the "
                  "other's, with the 95% interval of the difference. The better one is named only where that leaves out zero.",
                  study.scenes[scene].name, metric.title, describe(key), most_compared_runs),
      rows);
}

}  // namespace gibench::report
