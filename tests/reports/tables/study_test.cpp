#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "common/core/error.h"
#include "reports/collect/collect.h"
#include "reports/tables/method_style.h"
#include "reports/tables/study_tables.h"
#include "reports/writing/page_data.h"
#include "tests/reports/fixture/study_fixture.h"
#include "tests/support/scratch_folder.h"

namespace gibench::report {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class StudyFixture : public testing::Test {
 protected:
  StudyFixture() { gibench::test::write_study_fixture(folder_); }

  gibench::test::ScratchFolder scratch_;
  const fs::path& folder_ = scratch_.path();
};

const StudyRun& run_named(const Study& study, const std::string& id) {
  for (const StudyRun& run : study.runs)
    if (run.id == id) return run;
  throw std::runtime_error("no run " + id);
}

std::string message_of(const fs::path& folder) {
  try {
    collect_study(folder);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST_F(StudyFixture, CollectsWhatTheRecordsSay) {
  const Study study = collect_study(folder_);
  EXPECT_EQ(study.scenes.size(), 3U);
  EXPECT_FLOAT_EQ(study.scenes[0].exposure, 0.5F);
  EXPECT_EQ(study.scenes[2].skipped, "its model is not on GIBENCH_PATH");
  const StudyRun& run = run_named(study, "run-1-5");
  EXPECT_EQ(run.label, "meshless 3 levels");
  EXPECT_DOUBLE_EQ(*run.transport_seconds(Domain::surface), 0.05);
  EXPECT_EQ(run.method_bytes, 200'000U);
  EXPECT_EQ(run.seed, 1U);
  const MeasuredError* error = run.error({Domain::surface, Component::indirect, "relative_rmse"});
  EXPECT_NEAR(error->value, 0.2 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(*error->low, error->value * 0.95, 1e-12);
  EXPECT_EQ(run.error({Domain::surface, Component::direct, "relative_rmse"}), nullptr);
  EXPECT_THAT(run.effects->missing, ElementsAre(Effect::glossy_final_bounce));
}

const Cell& cell_in(const Table& table, std::size_t row, const std::string& column) {
  for (std::size_t c = 0; c < table.columns.size(); ++c)
    if (table.columns[c].name == column) return table.rows.at(row).at(c);
  throw std::runtime_error("no column " + column);
}

const std::string& text_in(const Table& table, std::size_t row, const std::string& column) {
  return cell_in(table, row, column).text;
}

TEST_F(StudyFixture, ErrorsAreSplitInTwoParts) {
  const Study study = collect_study(folder_);
  const ErrorKey key{Domain::surface, Component::indirect, "relative_rmse"};
  const StudyRun& meshless = run_named(study, "run-1-5");
  EXPECT_NEAR(meshless.model_error(key)->value, 0.05, 1e-12);
  EXPECT_NEAR(meshless.discretisation_error(key)->value, meshless.error(key)->value * 0.8, 1e-12);
  const StudyRun& whole = run_named(study, "run-1-1");
  EXPECT_EQ(whole.model_error(key), nullptr);
  EXPECT_EQ(whole.discretisation_error(key), whole.error(key)) << "all light paths: all error is of the discretisation";
  const Table split = split_table(study, key);
  ASSERT_EQ(split.rows.size(), 18U);
  EXPECT_THAT(text_in(split, 0, "model_error"), HasSubstr("all light paths"));
  EXPECT_THAT(text_in(split, 4, "model_error"), HasSubstr("5.00 %"));
  EXPECT_THAT(text_in(split, 4, "model_error"), HasSubstr("[")) << "the interval";
  EXPECT_EQ(text_in(split, 4, "missing"), "glossy_final_bounce");
  const Table bounces = bounce_table(study, key);
  ASSERT_EQ(bounces.rows.size(), 10U);
  EXPECT_THAT(text_in(bounces, 0, "discretisation_error"), HasSubstr("3.00 %"));
  EXPECT_TRUE(split_table(study, {Domain::surface, Component::direct, "magic"}).rows.empty());
}

TEST_F(StudyFixture, ScenesSayWhatTheyCallForAndWhatIsMissingHasASize) {
  const Study study = collect_study(folder_);
  const Table calls = call_table(study);
  ASSERT_EQ(calls.rows.size(), 2U);
  EXPECT_EQ(text_in(calls, 0, "direct"), "called for");
  EXPECT_EQ(text_in(calls, 0, "environment"), "not called for");
  EXPECT_EQ(text_in(calls, 0, "bounces"), "21 (for 0.001 of the light)");
  const Table evidence = evidence_table(study);
  ASSERT_EQ(evidence.rows.size(), 6U);
  EXPECT_EQ(text_in(evidence, 2, "evidence"), "largest albedo 0.73");
  const Table matrix = effect_matrix(study);
  ASSERT_EQ(matrix.rows.size(), 6U) << "two scenes, three methods";
  EXPECT_EQ(text_in(matrix, 0, "glossy_final_bounce"), "simulated");
  EXPECT_EQ(text_in(matrix, 0, "model_error"), "none");
  EXPECT_EQ(text_in(matrix, 1, "glossy_final_bounce"), "missing");
}

TEST_F(StudyFixture, BrokenRecordIsAFailedRunWithAWarning) {
  const Study study = collect_study(folder_);
  const StudyRun& run = run_named(study, "broken");
  EXPECT_EQ(run.status, RunStatus::failed);
  EXPECT_THAT(run.message, HasSubstr("not valid JSON"));
  EXPECT_THAT(study.warnings, ElementsAre(HasSubstr("run broken: runs/broken/result.json")));
  EXPECT_EQ(run_named(study, "late").status, RunStatus::timed_out);
  EXPECT_TRUE(run_named(study, "late").errors.empty());
}

TEST_F(StudyFixture, RecordOfTheWrongShapeIsAFailedRun) {
  for (const std::string text : {"[1, 2]", "{\"errors\": {\"indirect\": {\"surface\": 3}}}",
                                 "{\"errors\": {\"indirect\": {\"surface\": {\"rmse\": \"x\"}}}}", ""}) {
    std::ofstream(folder_ / "runs" / "run-1-1" / "result.json") << text;
    EXPECT_NO_THROW({
      const Study study = collect_study(folder_);
      EXPECT_TRUE(run_named(study, "run-1-1").errors.empty()) << text;
    });
  }
}

TEST_F(StudyFixture, AnErrorOfUnknownLightIsAFailedRunThatNamesIt) {
  std::ofstream(folder_ / "runs" / "run-1-1" / "result.json")
      << R"({"gibench_result": 1, "errors": {"magic": {"surface": {"rmse": {"value": 1}}}}})";
  const Study study = collect_study(folder_);
  const StudyRun& run = run_named(study, "run-1-1");
  EXPECT_EQ(run.status, RunStatus::failed);
  EXPECT_THAT(run.message, HasSubstr("unknown name 'magic'"));
  EXPECT_THAT(run.message, HasSubstr("direct, indirect, total"));
}

TEST_F(StudyFixture, PathsThatLeadOutAreNotFollowed) {
  std::ofstream(folder_ / "manifest.json")
      << R"({"gibench_study": 1, "runs": [{"id": "a", "scene": "s", "method": "m", "status": "refused", "folder": "../x"}]})";
  EXPECT_TRUE(collect_study(folder_).runs[0].folder.empty());
}

TEST_F(StudyFixture, WhatIsNoStudyIsRefused) {
  EXPECT_THAT(message_of(folder_ / "nowhere"), HasSubstr("is not a folder"));
  EXPECT_THAT(message_of(folder_ / "runs"), HasSubstr("holds no manifest.json"));
  std::ofstream(folder_ / "manifest.json") << "{\"gibench_study\": 1,";
  EXPECT_THAT(message_of(folder_), HasSubstr("manifest.json"));
  std::ofstream(folder_ / "manifest.json") << "{\"something\": 1}";
  EXPECT_THAT(message_of(folder_), HasSubstr("not a study manifest"));
  std::ofstream(folder_ / "manifest.json") << R"({"gibench_study": 1, "scenes": {"a": 1}, "runs": 7})";
  EXPECT_THAT(message_of(folder_), HasSubstr("manifest.json"));
}

TEST_F(StudyFixture, SceneTableShowsADashForWhatWasNotMeasured) {
  const Study study = collect_study(folder_);
  const Table whole = scene_table(study, 0, {Domain::surface, Component::indirect, "relative_rmse"});
  for (const auto& row : whole.rows) EXPECT_EQ(row.size(), whole.columns.size());
  EXPECT_THAT(to_csv(whole), HasSubstr("relative_rmse,relative_rmse_ci95_low,relative_rmse_ci95_high,relative_rmse_resolved,"));
  EXPECT_THAT(to_csv(whole),
              HasSubstr("speed_up,speed_up_ci95_low,speed_up_ci95_high,speed_up_is_lower_bound,speed_up_extrapolated,"));
  const Table table = shown(whole);
  ASSERT_EQ(table.rows.size(), 9U);
  EXPECT_EQ(table.rows[0][0].text, "pathtracer 16 spp");
  EXPECT_EQ(table.rows[0][3].text, "40.0 % [38.0, 42.4]");
  EXPECT_EQ(text_in(table, 0, "prepare_seconds"), "–") << "the path tracer prepares nothing";
  EXPECT_EQ(cell_in(table, 0, "prepare_seconds").raw, "");
  EXPECT_THAT(text_in(table, 4, "speed_up"), HasSubstr("40.0× ["));
  EXPECT_EQ(table.rows[8][3].text, "≤ 0.212 %");
  EXPECT_THAT(text_in(table, 8, "speed_up"), HasSubstr("≥ "));
  EXPECT_EQ(text_in(table, 8, "beside_best"), "best");
  EXPECT_THAT(text_in(table, 0, "beside_best"), HasSubstr("worse by 39.8 % ["));
}

TEST_F(StudyFixture, TablesOfTheWholeStudy) {
  const Study study = collect_study(folder_);
  const Table failures = failure_table(study);
  ASSERT_EQ(failures.rows.size(), 5U);
  EXPECT_EQ(failures.rows[0][0].text, "sibenik");
  EXPECT_EQ(failures.rows[2][3].text, "timed out");
  const Table matrix = effect_matrix(study);
  EXPECT_EQ(shown(matrix).columns.size(), 7U);
  EXPECT_EQ(matrix.rows.size(), 6U);
  for (const auto& row : matrix.rows) EXPECT_EQ(row.size(), matrix.columns.size());
  EXPECT_EQ(run_table(study).rows.size(), study.runs.size());
  std::size_t errors = 0;
  for (const StudyRun& run : study.runs) errors += run.errors.size();
  EXPECT_EQ(error_table(study).rows.size(), errors);
}

TEST_F(StudyFixture, DefaultErrorIsIndirectLightAtTheSurface) {
  const auto keys = measured_keys(collect_study(folder_));
  EXPECT_EQ(keys.front(), (ErrorKey{Domain::surface, Component::indirect, "relative_rmse"}));
  EXPECT_EQ(keys.size(), 3U * 8U + 3U * 12U);
}

TEST_F(StudyFixture, PageDataIsSafeInsideAScript) {
  Study study = collect_study(folder_);
  study.runs[0].message = "\xff\xfe broken bytes";
  const std::string data = page_data(study, std::vector<std::vector<PagePicture>>(study.scenes.size()), {});
  EXPECT_THAT(data, Not(HasSubstr("</script>")));
  EXPECT_THAT(data, HasSubstr("<\\/script>"));
  EXPECT_THAT(data, testing::StartsWith("gibench.study = {"));
}

TEST_F(StudyFixture, ScenesGetFileNamesWithoutSurprises) {
  const Study study = collect_study(folder_);
  EXPECT_EQ(scene_slug(study, 0), "scene-1-cornell-box");
  EXPECT_EQ(scene_slug(study, 1), "scene-2-two-rooms-a-wall-100-x-2");
}

TEST_F(StudyFixture, EveryMethodHasAStyleOfItsOwn) {
  Study study = collect_study(folder_);
  for (const std::string method : {"wavelet", "ifield", "new one"}) study.runs.emplace_back().method = method;
  const auto styles = method_styles(study);
  EXPECT_EQ(styles.front().method, "pathtracer");
  std::set<std::string> colours, shapes;
  for (const MethodStyle& style : styles) {
    colours.insert(style.colour);
    shapes.insert(style.shape);
  }
  EXPECT_EQ(styles.size(), 7U);
  EXPECT_EQ(colours.size(), styles.size());
  EXPECT_EQ(shapes.size(), styles.size());
  for (int extra = 0; extra < 10; ++extra) study.runs.emplace_back().method = "extra " + std::to_string(extra);
  EXPECT_EQ(method_styles(study).size(), 17U);
}

TEST_F(StudyFixture, RelightingsTellWhenPreparingHasPaid) {
  const Study study = collect_study(folder_);
  ASSERT_EQ(study.relights.size(), 2U);
  const Table table = relight_table(study);
  EXPECT_EQ(text_in(table, 0, "frames_that_pay"), "2 [2, 3]");
  EXPECT_EQ(text_in(table, 0, "times_cheaper"), "400× [300×, 500×]");
  EXPECT_EQ(text_in(table, 1, "frames_that_pay"), "≤ 4") << "the reference's noise hides the error";
  EXPECT_EQ(text_in(table, 1, "times_cheaper"), "≥ 200×");
  EXPECT_EQ(relit_frame_table(study).rows.size(), 4U);
  EXPECT_EQ(text_in(relit_frame_table(study), 0, "indirect_relative_rmse"), "2.00 % [1.90, 2.12]");
  EXPECT_EQ(
      relight_sentence(study.relights[0]),
      "relit on cornell-box: a frame takes 40.0 ms after 30.0 s of preparing; path tracing to the same error takes 400 [300, "
      "500] times that. Preparation has paid for itself after 2 [2, 3] frames.");
  EXPECT_THAT(relight_sentence(study.relights[1]), HasSubstr("at least 200 times"));
  EXPECT_THAT(relight_sentence(study.relights[1]), HasSubstr("after 4 frames at most"));
}

TEST_F(StudyFixture, ARelightingWithADamagedRecordFailsAndSaysWhy) {
  std::ofstream(folder_ / "runs" / "relit-1" / "relight.json") << "{\"frames\": ";
  const Study study = collect_study(folder_);
  ASSERT_EQ(study.relights.size(), 2U);
  EXPECT_EQ(study.relights[0].status, RunStatus::failed);
  EXPECT_THAT(study.relights[0].message, HasSubstr("relight.json"));
  EXPECT_EQ(relight_sentence(study.relights[0]), "");
  EXPECT_EQ(relight_table(study).rows.size(), 2U);
}

}  // namespace
}  // namespace gibench::report
