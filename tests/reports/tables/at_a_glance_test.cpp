#include "reports/tables/at_a_glance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "reports/tables/table_cells.h"

namespace gibench::report {
namespace {

using testing::HasSubstr;

const ErrorKey key{Domain::surface, Component::indirect, "relative_rmse"};

/// Seconds once, seconds for all of its 1000 points, and its error.
StudyRun run_of(const std::string& scene, const std::string& method, double once, double shading, double error) {
  StudyRun run;
  run.scene = scene, run.method = run.label = method;
  run.status = RunStatus::done;
  run.surface_samples = 1000;
  run.seconds[Stage::prepare] = once, run.seconds[Stage::shade_surface] = shading;
  run.errors[key] = {.value = error, .low = 0.9 * error, .high = 1.1 * error, .noise_floor = {}};
  return run;
}

/// The path tracer: an error of 0.1 in 10 s, 0.2 in 2.5 s.
void add_path_tracer(Study& study, const std::string& scene) {
  for (const auto& [seconds, error] : {std::pair{2.5, 0.2}, {10.0, 0.1}}) {
    StudyRun run = run_of(scene, baseline_method, 0.0, seconds, error);
    run.errors[key].low = run.errors[key].high = {};
    study.runs.push_back(run);
  }
}

Study study_of(std::vector<StudyRun> runs) {
  Study study;
  for (const StudyRun& run : runs) {
    if (study.scenes.empty() || study.scenes.back().name != run.scene) {
      study.scenes.emplace_back().name = run.scene;
      add_path_tracer(study, run.scene);
    }
    study.runs.push_back(run);
  }
  return study;
}

/// Of a table's first row.
Cell cell_of(const Table& table, const std::string& column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i)
    if (table.columns[i].name == column) return table.rows.at(0).at(i);
  return text_cell("no column " + column);
}
std::string text_of(const Table& table, const std::string& column) { return cell_of(table, column).text; }
std::string raw_of(const Table& table, const std::string& column) { return cell_of(table, column).raw; }

TEST(Verdict, IsDecidedByTheWholeInterval) {
  EXPECT_EQ(verdict_of({.factor = 2.0, .low = 1.5, .high = 3.0}), Verdict::ahead);
  EXPECT_EQ(verdict_of({.factor = 2.0, .low = 0.9, .high = 3.0}), Verdict::undecided);
  EXPECT_EQ(verdict_of({.factor = 0.5, .low = 0.4, .high = 1.1}), Verdict::undecided);
  EXPECT_EQ(verdict_of({.factor = 0.5, .low = 0.4, .high = 0.9}), Verdict::behind);
  EXPECT_EQ(verdict_of({.factor = 1.2, .at_least = true}), Verdict::ahead);
  EXPECT_EQ(verdict_of({.factor = 0.8, .at_least = true}), Verdict::undecided);
  EXPECT_EQ(verdict_of({.factor = 0.8}), Verdict::behind);
}

/// 4 s once and 1 ms a point; path tracing takes 10 ms a point to the same error: n = 4/(0.010 − 0.001).
TEST(BreakEvenOf, IsWherePreparingIsPaid) {
  const Study study = study_of({run_of("a", "m", 4.0, 1.0, 0.1)});
  const auto rows = glance_rows(study, key);
  ASSERT_EQ(rows.size(), 1U);
  ASSERT_TRUE(rows[0].points);
  EXPECT_NEAR(rows[0].points->number, 4.0 / (0.010 - 0.001), 1e-9);
  EXPECT_FALSE(rows[0].pictures) << "no picture was taken";
}

/// 13 ms a point: path tracing takes 12.3 ms at most, to the error of the interval's near end.
TEST(BreakEvenOf, IsNeverWherePathTracingIsCheaperForEachPoint) {
  const Study study = study_of({run_of("a", "m", 1.0, 13.0, 0.1)});
  const auto rows = glance_rows(study, key);
  ASSERT_TRUE(rows[0].points);
  EXPECT_TRUE(std::isinf(rows[0].points->number));
  EXPECT_EQ(text_of(glance_table(study, key, rows), "pays_from_points"), "never");
}

/// Path tracing to an error of e takes 10 s (0.1/e)² for 1000 points: at 0.09 and 0.11, the ends of the interval, 12.3 and 8.26
/// s.
TEST(BreakEvenOf, HasTheIntervalOfTheError) {
  const Study study = study_of({run_of("a", "m", 4.0, 1.0, 0.1)});
  const auto rows = glance_rows(study, key);
  ASSERT_TRUE(rows[0].points && rows[0].points->low && rows[0].points->high);
  EXPECT_NEAR(*rows[0].points->low, 4.0 / (0.010 / 0.81 - 0.001), 1e-9);
  EXPECT_NEAR(*rows[0].points->high, 4.0 / (0.010 / 1.21 - 0.001), 1e-9);
  const Table table = glance_table(study, key, rows);
  EXPECT_EQ(text_of(table, "pays_from_points"), "445 [353, 551]");
  EXPECT_EQ(raw_of(table, "pays_from_points_ci95_low"), exact(*rows[0].points->low));
  EXPECT_EQ(raw_of(table, "pays_from_points_ci95_high"), exact(*rows[0].points->high));
}

/// 9 ms a point: path tracing takes 10 ms to the same error, 8.26 ms to that of the interval's far end; and 11 ms a point.
TEST(BreakEvenOf, MayBeNeverAtAnEndOfItsInterval) {
  const Study pays = study_of({run_of("a", "m", 4.0, 9.0, 0.1)}), never = study_of({run_of("a", "m", 4.0, 11.0, 0.1)});
  EXPECT_EQ(text_of(glance_table(pays, key, glance_rows(pays, key)), "pays_from_points"), "4000 [1196, never]");
  EXPECT_EQ(text_of(glance_table(never, key, glance_rows(never, key)), "pays_from_points"), "never [2973, never]");
}

/// The error may be far smaller than the end of its interval, at which path tracing is cheaper for each point.
TEST(BreakEvenOf, IsOpenWhereTheErrorIsNotResolvedAndDoesNotPayAtItsFarEnd) {
  Study study = study_of({run_of("a", "m", 4.0, 9.0, 0.1)});
  study.runs.back().errors[key].resolved = false;
  const Table table = glance_table(study, key, glance_rows(study, key));
  EXPECT_EQ(text_of(table, "pays_from_points"), "undecided");
  EXPECT_EQ(raw_of(table, "pays_from_points"), "");
}

TEST(BreakEvenOf, IsAnUpperBoundWhereTheErrorIsNotResolved) {
  Study study = study_of({run_of("a", "m", 4.0, 1.0, 0.1)});
  study.runs.back().errors[key].resolved = false;
  const auto rows = glance_rows(study, key);
  ASSERT_TRUE(rows[0].points);
  EXPECT_TRUE(rows[0].points->at_most);
  EXPECT_THAT(text_of(glance_table(study, key, rows), "pays_from_points"), testing::StartsWith("≤ "));
}

TEST(GlanceSentence, CountsScenesAndNamesTheBest) {
  const Study study = study_of({run_of("a", "slow", 8.0, 1.0, 0.1), run_of("a", "fast", 1.0, 0.0, 0.1),
                                run_of("b", "slow", 80.0, 1.0, 0.1), run_of("c", "slow", 8.9, 1.0, 0.1)});
  const auto rows = glance_rows(study, key);
  EXPECT_EQ(study.runs[rows[0].run].method, "fast") << "the fastest of a scene comes first";
  const std::string sentence = glance_sentence(study, key, rows);
  EXPECT_THAT(sentence, HasSubstr("On 1 of 3 scenes a method"));
  EXPECT_THAT(sentence, HasSubstr("fast on a (10.0×)"));
  EXPECT_THAT(sentence, HasSubstr("Path tracing is ahead of all of them on b."));
  EXPECT_THAT(sentence, HasSubstr("The intervals leave it open on c."));
}

TEST(GlanceSentence, SaysThatNoneIsAhead) {
  const Study study = study_of({run_of("a", "slow", 80.0, 1.0, 0.1)});
  EXPECT_THAT(glance_sentence(study, key, glance_rows(study, key)),
              HasSubstr("On none of 1 scene does a method reach its error"));
}

TEST(GlanceSentence, SaysWhereNothingCanBeCompared) {
  EXPECT_EQ(glance_sentence(Study{}, key, {}), "No run can be compared with path tracing.");
}

}  // namespace
}  // namespace gibench::report
