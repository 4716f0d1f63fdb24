#include "reports/collect/compare_runs.h"

#include <algorithm>
#include <set>

#include "bench/record/checksums.h"
#include "bench/record/pair_record.h"
#include "common/core/error.h"
#include "reports/tables/metric_info.h"

namespace gibench::report {
namespace {

using RunPositions = std::vector<std::size_t>;

/// The runs with this error and the terms of it, the smallest shown error first, so many as are compared.
RunPositions most_accurate(const Study& study, const RunPositions& runs, const ErrorKey& key) {
  const Metric metric = metric_info(key.metric);
  std::vector<std::pair<double, std::size_t>> order;
  for (const std::size_t run : runs)
    if (const MeasuredError* error = study.runs[run].error(key); error && !study.runs[run].pair_checksum.empty())
      order.emplace_back(shown_badness(metric, *error), run);
  std::ranges::sort(order);
  RunPositions compared;
  for (const auto& [badness, run] : order)
    if (compared.size() < most_compared_runs) compared.push_back(run);
  return compared;
}

/// The terms of one run; empty, and a warning, for a file that is not as it was written.
std::optional<PairRecord> terms_of(Study& study, const StudyRun& run) {
  try {
    if (const auto damaged = damaged_files(run.folder, {{pair_file, run.pair_checksum}}); !damaged.empty())
      throw InputError((run.folder / pair_file).string(), damaged.front().problem, "run the study again");
    return read_pair_record(run.folder / pair_file);
  } catch (const InputError& error) {
    study.warnings.push_back("run " + run.id + " is not compared with others: " + without_folder(study, error.what()));
    return std::nullopt;
  }
}

/// Pair by pair, in the order of the runs given.
std::vector<Comparison> compared(const RunPositions& runs, const std::map<std::size_t, PairRecord>& terms, const ErrorKey& key) {
  std::vector<Comparison> comparisons;
  const std::string by = paired_by(key.metric).value();
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (std::size_t j = i + 1; j < runs.size(); ++j) {
      const auto a = terms.find(runs[i]), b = terms.find(runs[j]);
      if (a == terms.end() || b == terms.end() || !can_be_compared(a->second, b->second)) continue;
      const PairTerms* const of_a = a->second.terms(key.component, key.domain, by);
      const PairTerms* const of_b = b->second.terms(key.component, key.domain, by);
      if (!of_a || !of_b || of_a->parts.size() != of_b->parts.size() || of_a->influences.size() != of_b->influences.size())
        continue;
      if (const auto apart = difference_of(key.metric, *of_a, *of_b))
        comparisons.push_back({runs[i], runs[j], apart->value, apart->interval.low, apart->interval.high});
    }
  return comparisons;
}

}  // namespace

void compare_runs(Study& study, const std::function<void()>& may_go_on) {
  for (StudyScene& scene : study.scenes) {
    const RunPositions runs = study.runs_of(scene.name);
    std::set<ErrorKey> keys;
    for (const std::size_t run : runs)
      for (const auto& [key, error] : study.runs[run].errors)
        if (!study.runs[run].pair_checksum.empty() && paired_by(key.metric)) keys.insert(key);
    std::map<ErrorKey, RunPositions> accurate;
    std::map<std::size_t, PairRecord> terms;
    for (const ErrorKey& key : keys) accurate[key] = most_accurate(study, runs, key);
    std::set<std::size_t> wanted;
    for (const auto& [key, of_key] : accurate) wanted.insert(of_key.begin(), of_key.end());
    for (const std::size_t run : wanted) {
      may_go_on();
      if (auto read = terms_of(study, study.runs[run])) terms.emplace(run, std::move(*read));
    }
    for (const auto& [key, of_key] : accurate)
      if (auto comparisons = compared(of_key, terms, key); !comparisons.empty()) scene.comparisons[key] = std::move(comparisons);
  }
}

}  // namespace gibench::report
