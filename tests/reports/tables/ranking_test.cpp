#include "reports/tables/ranking.h"

#include <gtest/gtest.h>

#include <cmath>

#include "reports/tables/study_tables.h"

namespace gibench::report {
namespace {

const ErrorKey key{Domain::surface, Component::indirect, "relative_rmse"};

StudyRun run_of(const std::string& scene, const std::string& method, const std::string& label, double seconds, double error) {
  StudyRun run;
  run.scene = scene;
  run.method = method;
  run.label = label;
  run.status = RunStatus::done;
  run.seconds[Stage::shade_surface] = seconds;
  run.errors[key] = {.value = error, .low = {}, .high = {}, .noise_floor = 1e-4};
  return run;
}

Study study_of(const std::vector<std::string>& scenes, std::vector<StudyRun> runs) {
  Study study;
  for (const std::string& name : scenes) study.scenes.emplace_back().name = name;
  study.runs = std::move(runs);
  return study;
}

const RankingRow& row_of(const std::vector<RankingRow>& rows, const std::string& label) {
  for (const RankingRow& row : rows)
    if (row.label == label) return row;
  throw std::runtime_error("no row " + label);
}

/// A path tracer whose errors have no intervals, with the slope of the RMSE.
Baseline exact_baseline(const std::vector<std::pair<double, double>>& points) {
  const BaselineCurve curve(points, -0.5);
  return {curve, curve, curve};
}

StudyRun with_interval(StudyRun run, double low, double high) {
  run.errors[key].low = low, run.errors[key].high = high;
  return run;
}

TEST(BaselineCurve, InterpolatesInLogLogAndContinuesWithTheSlope) {
  const BaselineCurve curve({{4.0, 0.1}, {1.0, 0.2}}, -0.5);
  EXPECT_NEAR(curve.seconds_at(0.2)->seconds, 1.0, 1e-12);
  EXPECT_FALSE(curve.seconds_at(0.2)->extrapolated);
  EXPECT_NEAR(curve.seconds_at(0.1)->seconds, 4.0, 1e-12);
  EXPECT_NEAR(curve.seconds_at(0.2 / std::sqrt(2.0))->seconds, 2.0, 1e-12);
  EXPECT_NEAR(curve.seconds_at(0.01)->seconds, 400.0, 1e-9);
  EXPECT_TRUE(curve.seconds_at(0.01)->extrapolated);
  EXPECT_NEAR(curve.seconds_at(0.4)->seconds, 0.25, 1e-12);
  EXPECT_TRUE(curve.seconds_at(0.4)->extrapolated);
}

TEST(BaselineCurve, LeavesOutRunsThatCheaperOnesBeat) {
  const BaselineCurve curve({{1.0, 0.2}, {2.0, 0.3}, {4.0, 0.1}}, -0.5);
  EXPECT_NEAR(curve.seconds_at(0.2 / std::sqrt(2.0))->seconds, 2.0, 1e-12);
}

TEST(BaselineCurve, SaysNothingWithoutPointsOrSlope) {
  EXPECT_FALSE(BaselineCurve({}, -0.5).seconds_at(0.1));
  EXPECT_FALSE(BaselineCurve({{1.0, 0.2}, {4.0, 0.1}}, {}).seconds_at(0.01));
  EXPECT_TRUE(BaselineCurve({{1.0, 0.2}, {4.0, 0.1}}, {}).seconds_at(0.15));
  EXPECT_FALSE(BaselineCurve({{1.0, 0.2}}, -0.5).seconds_at(0.0));
  EXPECT_FALSE(BaselineCurve({{1.0, 0.0}, {0.0, 0.1}}, -0.5).seconds_at(0.1));
}

TEST(SpeedUp, OfAnErrorThatIsNotResolvedIsALowerBound) {
  const Baseline curve = exact_baseline({{1.0, 0.2}, {4.0, 0.1}});
  StudyRun run = run_of("a", "m", "m", 1.0, 1e-6);
  run.errors[key].resolved = false;
  run.errors[key].low = 0.0, run.errors[key].high = 0.05;
  const auto speed = speed_up(curve, run, key);
  EXPECT_NEAR(speed->factor, 16.0, 1e-9);
  EXPECT_TRUE(speed->at_least);
  run.method = baseline_method;
  EXPECT_DOUBLE_EQ(speed_up(curve, run, key)->factor, 1.0);
  EXPECT_FALSE(speed_up(curve, run, key)->at_least);
}

TEST(SpeedUp, AbsentForWhatWasNotMeasured) {
  const Baseline curve = exact_baseline({{1.0, 0.2}, {4.0, 0.1}});
  StudyRun run = run_of("a", "m", "m", 1.0, 0.1);
  EXPECT_FALSE(speed_up(curve, run, {Domain::image, Component::indirect, "relative_rmse"}));
  run.status = RunStatus::timed_out;
  EXPECT_FALSE(speed_up(curve, run, key));
  run.status = RunStatus::done;
  run.seconds.clear();
  EXPECT_FALSE(speed_up(curve, run, key));
}

TEST(SpeedUp, HasTheIntervalOfTheRunsError) {
  const Baseline curve = exact_baseline({{1.0, 0.2}, {4.0, 0.1}});
  const auto speed = speed_up(curve, with_interval(run_of("a", "m", "m", 0.1, 0.1), 0.05, 0.2), key);
  EXPECT_NEAR(speed->factor, 40.0, 1e-9);
  EXPECT_NEAR(*speed->low, 10.0, 1e-9);
  EXPECT_NEAR(*speed->high, 160.0, 1e-9);
}

TEST(SpeedUp, AnErrorThatMayBeNothingHasNoHighEnd) {
  const Baseline curve = exact_baseline({{1.0, 0.2}, {4.0, 0.1}});
  const ErrorKey bias{Domain::surface, Component::indirect, "bias"};
  StudyRun run = run_of("a", "m", "m", 0.1, 0.1);
  run.errors[bias] = {.value = 0.1, .low = -0.05, .high = 0.2, .noise_floor = {}};
  const auto speed = speed_up(curve, run, bias);
  EXPECT_NEAR(*speed->low, 10.0, 1e-9);
  EXPECT_FALSE(speed->high);
}

TEST(SpeedUp, HasTheIntervalsOfThePathTracersErrors) {
  const Study study = study_of({"a"}, {with_interval(run_of("a", "pathtracer", "pt", 4.0, 0.1), 0.08, 0.12)});
  const auto speed = speed_up(baseline_of(study, "a", key, ""), with_interval(run_of("a", "m", "m", 1.0, 0.1), 0.1, 0.1), key);
  EXPECT_NEAR(speed->factor, 4.0, 1e-9);
  EXPECT_NEAR(*speed->low, 4.0 * 0.64, 1e-9);
  EXPECT_NEAR(*speed->high, 4.0 * 1.44, 1e-9);
}

TEST(SpeedUp, LiesInItsInterval) {
  const Study study = study_of({"a"}, {with_interval(run_of("a", "pathtracer", "fast", 1.0, 0.2), 0.18, 0.22),
                                       with_interval(run_of("a", "pathtracer", "slow", 4.0, 0.18), 0.1, 0.26)});
  const auto speed =
      speed_up(baseline_of(study, "a", key, ""), with_interval(run_of("a", "m", "m", 0.1, 0.18), 0.179, 0.181), key);
  EXPECT_LE(*speed->low, speed->factor);
  EXPECT_GE(*speed->high, speed->factor);
}

TEST(TransportSeconds, AddsTheStagesOfTheDomain) {
  StudyRun run;
  run.seconds = {
      {Stage::load, 100.0}, {Stage::prepare, 1.0}, {Stage::light, 2.0}, {Stage::shade_surface, 4.0}, {Stage::shade, 12.0}};
  EXPECT_DOUBLE_EQ(*run.transport_seconds(Domain::surface), 7.0);
  EXPECT_DOUBLE_EQ(*run.transport_seconds(Domain::image), 15.0);
  run.seconds = {{Stage::load, 1.0}, {Stage::prepare, 1.0}};
  EXPECT_FALSE(run.transport_seconds(Domain::surface));
}

TEST(Ranking, GeometricMeanRanksAndFront) {
  const Study study =
      study_of({"a", "b"}, {run_of("a", "pathtracer", "pt 1", 1.0, 0.2), run_of("a", "pathtracer", "pt 4", 4.0, 0.1),
                            run_of("a", "m", "m", 0.1, 0.1), run_of("b", "pathtracer", "pt 1", 1.0, 0.2),
                            run_of("b", "pathtracer", "pt 4", 4.0, 0.1), run_of("b", "m", "m", 0.4, 0.1)});
  const auto rows = rank(study, key);
  const RankingRow& m = row_of(rows, "m");
  EXPECT_EQ(rows.front().label, "m");
  EXPECT_NEAR(m.scenes[0].speed_up->factor, 40.0, 1e-9);
  EXPECT_NEAR(m.scenes[1].speed_up->factor, 10.0, 1e-9);
  EXPECT_NEAR(*m.geometric_mean, 20.0, 1e-9);
  EXPECT_EQ(m.scenes[0].error_rank, 1);
  EXPECT_EQ(m.on_front, 2);
  EXPECT_EQ(row_of(rows, "pt 4").scenes[0].error_rank, 1);
  EXPECT_EQ(row_of(rows, "pt 4").on_front, 0);
  EXPECT_EQ(row_of(rows, "pt 1").scenes[0].error_rank, 3);
  EXPECT_NEAR(*row_of(rows, "pt 1").geometric_mean, 1.0, 1e-12);
}

TEST(Ranking, TheGeometricMeanHasItsIntervalAndItsMarks) {
  const Study study = study_of({"a", "b"}, {run_of("a", "pathtracer", "pt", 1.0, 0.2), run_of("b", "pathtracer", "pt", 1.0, 0.2),
                                            with_interval(run_of("a", "m", "m", 0.1, 0.2), 0.1, 0.4),
                                            with_interval(run_of("b", "m", "m", 0.1, 0.1), 0.05, 0.2)});
  const auto rows = rank(study, key);
  const RankingRow& m = row_of(rows, "m");
  EXPECT_NEAR(*m.geometric_mean, 20.0, 1e-9);  // 10 and 40
  // Each scene's factor may be four times less or more: log(4) * sqrt(2) / 2 of the mean.
  const double spread = std::exp(std::log(4.0) / std::sqrt(2.0));
  EXPECT_NEAR(*m.mean_low, 20.0 / spread, 1e-9);
  EXPECT_NEAR(*m.mean_high, 20.0 * spread, 1e-9);
  EXPECT_TRUE(m.extrapolated);
  const Table table = ranking_table(study, key, rows);
  EXPECT_EQ(table.rows[0][2].text, "20.0× [7.50, 53.3] *");
  EXPECT_NE(to_csv(table).find("geometric_mean_speed_up,geometric_mean_ci95_low,geometric_mean_ci95_high"), std::string::npos);
  EXPECT_EQ(to_markdown(table).find("ci95"), std::string::npos);
}

/// All that is known of `run` is that its error is at most `bound`.
StudyRun not_resolved(StudyRun run, double bound) {
  run.errors[key] = {.value = 0.5 * bound, .low = 0.0, .high = bound, .noise_floor = 1e-4, .resolved = false};
  return run;
}

TEST(Ranking, AnErrorThatIsNotResolvedRanksByItsBound) {
  const Study study =
      study_of({"a"}, {run_of("a", "m", "small", 1.0, 0.02), not_resolved(run_of("a", "m", "wide", 1.0, 0.0), 0.3),
                       not_resolved(run_of("a", "m", "narrow", 1.0, 0.0), 0.01), run_of("a", "m", "large", 1.0, 0.4),
                       not_resolved(run_of("a", "m", "as wide", 1.0, 0.0), 0.3)});
  const auto rows = rank(study, key);
  const auto rank_of = [&](const char* label) { return row_of(rows, label).scenes[0].error_rank; };
  EXPECT_EQ(rank_of("narrow"), 1);
  EXPECT_EQ(rank_of("small"), 2);
  EXPECT_EQ(rank_of("wide"), 3);
  EXPECT_EQ(rank_of("as wide"), 3);
  EXPECT_EQ(rank_of("large"), 5);
  EXPECT_EQ(rows.front().label, "narrow");
}

TEST(Ranking, TheFrontIsOfBoundsWhereErrorsAreNotResolved) {
  const Study study =
      study_of({"a"}, {not_resolved(run_of("a", "m", "fast and unknown", 1.0, 0.0), 0.5), run_of("a", "m", "slower", 2.0, 0.1),
                       run_of("a", "m", "slower and worse", 2.0, 0.2), not_resolved(run_of("a", "m", "slow", 3.0, 0.0), 0.2),
                       not_resolved(run_of("a", "m", "slowest", 4.0, 0.0), 0.05), run_of("a", "m", "too late", 5.0, 0.06)});
  const auto rows = rank(study, key);
  for (const char* label : {"fast and unknown", "slower", "slowest"}) EXPECT_EQ(row_of(rows, label).on_front, 1) << label;
  for (const char* label : {"slower and worse", "slow", "too late"}) EXPECT_EQ(row_of(rows, label).on_front, 0) << label;
}

/// Of a metric whose larger values are the better ones, the far end is the low one.
TEST(Ranking, BoundsOfMetricsThatAreLargerWhereBetter) {
  const ErrorKey psnr{Domain::image, Component::total, "psnr"};
  Study study = study_of({"a"}, {run_of("a", "m", "known", 1.0, 0.0), run_of("a", "m", "unknown", 1.0, 0.0)});
  for (StudyRun& run : study.runs) run.seconds[Stage::shade_image] = 1.0;
  study.runs[0].errors[psnr] = {.value = 30.0, .low = 29.0, .high = 31.0, .noise_floor = {}};
  study.runs[1].errors[psnr] = {.value = 35.0, .low = 20.0, .high = 60.0, .noise_floor = {}, .resolved = false};
  const auto rows = rank(study, psnr);
  EXPECT_EQ(row_of(rows, "known").scenes[0].error_rank, 1);
  EXPECT_EQ(row_of(rows, "unknown").scenes[0].error_rank, 2);
  EXPECT_EQ(row_of(rows, "unknown").on_front, 0);
}

TEST(Ranking, MoreAnsweredScenesComeFirstAndFailuresAreCounted) {
  StudyRun refused = run_of("b", "m", "m", 0.0, 0.0);
  refused.status = RunStatus::refused;
  refused.errors.clear();
  const Study study = study_of({"a", "b"}, {run_of("a", "pathtracer", "pt", 1.0, 0.2), run_of("b", "pathtracer", "pt", 1.0, 0.2),
                                            run_of("a", "m", "m", 0.001, 0.1), refused});
  const auto rows = rank(study, key);
  EXPECT_EQ(rows.front().label, "pt");
  EXPECT_EQ(row_of(rows, "m").compared, 1);
  EXPECT_EQ(row_of(rows, "m").not_done, 1);
  const Table table = ranking_table(study, key, rows);
  EXPECT_EQ(shown(table).rows.back().back().text, "refused");
}

TEST(Ranking, RunsOfOneLabelOnOneSceneKeepTheirOwnRows) {
  const Study study = study_of(
      {"a"}, {run_of("a", "pathtracer", "pt", 1.0, 0.2), run_of("a", "m", "m", 0.5, 0.1), run_of("a", "m", "m", 0.25, 0.1)});
  EXPECT_EQ(rank(study, key).size(), 3U);
}

TEST(Ranking, RunsAreComparedWithThePathTracerOnTheirOwnMachine) {
  Study study = study_of({"a"}, {run_of("a", "pathtracer", "slow", 4.0, 0.1), run_of("a", "pathtracer", "fast", 1.0, 0.1),
                                 run_of("a", "m", "on slow", 0.5, 0.1), run_of("a", "m", "on fast", 0.5, 0.1),
                                 run_of("a", "m", "elsewhere", 0.5, 0.1)});
  for (const std::size_t run : {0U, 2U}) study.runs[run].machine = "slow";
  for (const std::size_t run : {1U, 3U}) study.runs[run].machine = "fast";
  study.runs[4].machine = "another";
  const auto rows = rank(study, key);
  EXPECT_NEAR(row_of(rows, "on slow").scenes[0].speed_up->factor, 8.0, 1e-9);
  EXPECT_NEAR(row_of(rows, "on fast").scenes[0].speed_up->factor, 2.0, 1e-9);
  EXPECT_FALSE(row_of(rows, "elsewhere").scenes[0].speed_up);
  EXPECT_EQ(study.machines(), (std::vector<std::string>{"slow", "fast", "another"}));
}

TEST(Ranking, WithoutPathTracerThereAreRanksButNoSpeedUps) {
  const Study study = study_of({"a"}, {run_of("a", "m", "m", 0.5, 0.1), run_of("a", "n", "n", 0.5, 0.2)});
  const auto rows = rank(study, key);
  EXPECT_EQ(rows[0].label, "m");
  EXPECT_FALSE(rows[0].geometric_mean);
  EXPECT_EQ(rows[1].scenes[0].error_rank, 2);
  EXPECT_EQ(ranking_table(study, key, rows).rows[0][2].text, "–");
}

}  // namespace
}  // namespace gibench::report
