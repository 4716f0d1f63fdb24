/// Every record is read as it was written.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "bench/record/error_record.h"
#include "bench/record/process_record.h"
#include "bench/record/reference_record.h"
#include "bench/record/relight_record.h"
#include "bench/record/run_record.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using testing::HasSubstr;

ErrorTable errors() {
  ErrorTable table;
  table["rmse"] = {0.1, 0.05, 0.2, 0.01, false, 0.03};
  table["bias"] = {-0.25, -0.5, 0.125, std::nullopt, false};
  table["ssim"] = {0.9, -std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(), std::nullopt, false};
  return table;
}

ReferenceFacts reference_facts() {
  ReferenceFacts facts;
  facts.key = "abc", facts.path_class = "C.*[LOB]", facts.samples_per_replica = 64, facts.replicas = 8, facts.seconds = 1.5;
  facts.surface_error = 0.01, facts.image_error = 0.02;
  return facts;
}

RunRecord run_record() {
  RunRecord record;
  record.scene = "box", record.method = "meshless", record.seed = 7, record.threads = 2;
  record.parameters = {{"adaptive", true}, {"levels", std::int64_t{4}}, {"radius", 1.0}, {"mode", std::string("fast")}};
  record.origin = {"1.0", "c0ffee", {"cpu", "os", "g++", "Release", 2, 1024}};
  record.measured_at = {2048, 3, MeasuredCamera{"main", 64, 48}, 4, "all", 0.25};
  record.plan.called_for = {Effect::direct, Effect::diffuse_indirect, Effect::glossy_chain};
  record.plan.simulated = {Effect::direct, Effect::diffuse_indirect};
  record.plan.missing = {Effect::glossy_chain};
  record.plan.skipped = {{Effect::environment, "no environment light"}};
  record.plan.max_bounces = 12;
  record.light_paths = "C.{0,1}[LOB]", record.completed = {Component::direct}, record.load_seconds = 0.5;
  StageRecord prepare{Stage::prepare, {}}, surface{Stage::shade_surface, {}}, image{Stage::shade_image, {}};
  prepare.report.termination = Termination::bound_reached, prepare.report.message = "12 bounces", prepare.report.seconds = 2.0;
  prepare.report.counters.add("links", 17);
  surface.report.seconds = 0.25, image.report.seconds = 0.5;
  record.stages = {prepare, surface, image};
  record.method_bytes = 4096, record.peak_bytes = 8192;
  record.counters.add("closest_hit_rays", 1'000'000'000'000ULL);
  record.warnings = {"a warning"};
  record.exposure = Exposure{0.5F, -2.0F, 4.0F};
  record.errors[Component::indirect][Domain::surface] = errors();
  record.method_seeds = {7, 8}, record.files = {{"pairs.cbor", "00ff"}};
  record.reference = reference_facts();
  ComponentErrors of_total;
  of_total[Component::total][Domain::image] = errors();
  record.split = ErrorSplit{of_total, of_total, reference_facts()};
  record.per_bounce.push_back({0, std::nullopt, of_total});
  record.per_bounce.push_back({1, of_total, of_total});
  return record;
}

TEST(RunRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  const auto written = to_json(run_record());
  write_file_atomically(folder / result_file, written.dump(2));
  const RunRecord read = read_run_record(folder / result_file);
  EXPECT_EQ(to_json(read).dump(2), written.dump(2));
  EXPECT_EQ(read.parameters, run_record().parameters) << "with their types";
  EXPECT_EQ(read.plan.missing, EffectSet{Effect::glossy_chain});
  EXPECT_EQ(termination_of(read), Termination::bound_reached);
  EXPECT_EQ(read.stages[0].report.counters["links"], 17U);
  EXPECT_EQ(read.errors.at(Component::indirect).at(Domain::surface).at("rmse").noise_floor, 0.01);
  EXPECT_FALSE(read.per_bounce[0].model.has_value());
  EXPECT_EQ(read.method_seeds, (std::vector<std::uint64_t>{7, 8}));
  EXPECT_EQ(read.files, run_record().files);
  EXPECT_EQ(read.errors.at(Component::indirect).at(Domain::surface).at("rmse").seed_deviation, 0.03);
}

TEST(RunRecord, SaysWhatIntervalsCover) {
  using testing::ElementsAre;
  RunRecord record = run_record();
  EXPECT_THAT(covered_by_intervals(record), ElementsAre("reference", "points", "method_seed"));
  record.method_seeds.clear();
  EXPECT_THAT(covered_by_intervals(record), ElementsAre("reference", "points"));
  EXPECT_FALSE(to_json(record).contains("method_seeds")) << "what was not measured is absent";
  record.noise_of_points = true;
  EXPECT_THAT(covered_by_intervals(record), ElementsAre("reference", "points", "method_seed"));
  EXPECT_TRUE(run_record_of(to_json(record)).noise_of_points);
}

TEST(RunRecord, OfLittleIsReadAsItWasWritten) {
  RunRecord record;
  record.scene = "box", record.complete = true;
  record.errors[Component::direct][Domain::surface] = errors();
  const auto written = to_json(record);
  EXPECT_EQ(to_json(run_record_of(written)), written);
  EXPECT_TRUE(run_record_of(written).complete);
}

TEST(RunRecord, WhatIsNoneIsRefusedByName) {
  const test::ScratchFolder folder;
  for (const std::string text : {"[1]", "{}", "{\"gibench_result\": 1, \"seed\": \"x\"}", "{\"gibench_result\": 2}",
                                 "{\"gibench_result\": 1, \"effects\": {\"missing\": [\"magic\"]}}",
                                 "{\"gibench_result\": 1, \"stages\": [{\"stage\": \"magic\", \"termination\": \"done\"}]}"}) {
    write_file_atomically(folder / result_file, text);
    try {
      read_run_record(folder / result_file);
      ADD_FAILURE() << "it was taken: " << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("result.json")) << text;
    }
  }
}

TEST(RunRecord, EveryTerminationAndStageIsReadByItsName) {
  for (const Termination termination : all_terminations)
    for (const Stage stage : {Stage::prepare, Stage::light, Stage::shade_surface, Stage::shade_image}) {
      RunRecord record;
      record.stages = {{stage, {}}};
      record.stages.front().report.termination = termination;
      const RunRecord read = run_record_of(to_json(record));
      EXPECT_EQ(read.stages.front().stage, stage);
      EXPECT_EQ(read.stages.front().report.termination, termination) << to_string(termination);
    }
}

TEST(RelightRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  RelitFrame frame;
  frame.at = 0.5, frame.switched = {"paint"}, frame.relight_seconds = 0.25, frame.shade_seconds = 0.125;
  frame.errors[Component::indirect] = errors();
  frame.reference = PathTraced{2.0, 0.5, 512.0};
  frame.path_tracing = {std::nullopt, 3.0, std::nullopt};
  RelightRecord record{"box", "spectral", 3, {{"vertices", std::int64_t{600}}}, {frame, frame}, {}};
  record.summary = summarise(4.0, record.frames);
  const auto written = to_json(record);
  write_file_atomically(folder / relight_file, written.dump(2));
  const RelightRecord read = read_relight_record(folder / relight_file);
  EXPECT_EQ(to_json(read).dump(2), written.dump(2));
  EXPECT_EQ(read.summary.frames, 2U);
  EXPECT_EQ(read.summary.path_tracing_seconds->low, 3.0);
  EXPECT_EQ(read.summary.path_tracing_seconds->value, std::nullopt);
}

TEST(ReferenceRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  const ReferenceRecord record{
      reference_facts(),          "box", Exposure{1.0F, -1.0F, 3.0F}, MeasuredCamera{"main", 8, 6}, "1.0", "c0ffee",
      {{"reference.exr", "00ff"}}};
  write_file_atomically(folder / reference_file, to_json(record).dump(2));
  const ReferenceRecord read = read_reference_record(folder / reference_file);
  EXPECT_EQ(to_json(read).dump(2), to_json(record).dump(2));
  EXPECT_EQ(read.facts.total_samples(), 512U);
}

TEST(ProcessRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  ProcessRecord record;
  record.key = "k", record.status = RunStatus::refused, record.exit_code = 4, record.error = ErrorCode::refused;
  record.message = "refused: it cannot", record.wall_seconds = 0.5, record.peak_bytes = 10, record.process_peak_bytes = 20;
  write_file_atomically(folder / process_file, to_json(record).dump(2));
  const auto read = read_process_record(folder / process_file);
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(to_json(*read).dump(2), to_json(record).dump(2));
  EXPECT_EQ(read->error, ErrorCode::refused);
  EXPECT_FALSE(read_process_record(folder / "nowhere.json").has_value());
}

TEST(ErrorRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  write_error_record(folder / "error", {ErrorCode::missing_file, "there is no file"});
  const auto read = read_error_record(folder / "error");
  ASSERT_TRUE(read.has_value());
  EXPECT_EQ(read->code, ErrorCode::missing_file);
  EXPECT_EQ(read->message, "there is no file");
  write_file_atomically(folder / "error", std::string("{\"error\": \"bad"));
  EXPECT_FALSE(read_error_record(folder / "error").has_value()) << "cut short";
  EXPECT_FALSE(read_error_record(folder / "nowhere").has_value());
}

}  // namespace
}  // namespace gibench
