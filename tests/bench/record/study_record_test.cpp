/// What a scene's check and a study say is read as it was written.
#include "bench/record/study_record.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using testing::HasSubstr;

SceneAnalysis analysis() {
  GeometryReport geometry;
  geometry.faces = 7, geometry.quads = 6, geometry.triangles = 1, geometry.vertices = 24, geometry.components = 2;
  geometry.closed = geometry.oriented = true, geometry.bounds_max = {1.0, 2.0, 3.0}, geometry.area = 22.0, geometry.volume = -6.0;
  return {"abc",
          geometry,
          {{Effect::direct, true, "1 emitting material ('lamp')"}, {Effect::environment, false, "no environment light"}},
          {0.001, 21, true, "largest albedo 0.73"},
          0.25};
}

CheckRecord check_record() {
  CheckRecord record;
  record.scene = "box", record.file = "box.scene.json", record.analysis = analysis();
  record.coincident = {1, 2, 3};
  record.spaces = {22.0, 10.0, 1.0, 5.0, 0.5, 9.0, true, {{"lamp", true, 2.0, {1.0, 0.5, 3.0}, {0.25, 0.0, 0.75}}}, {}};
  record.cameras = {{"main", 64, 48}, {"side", 8, 6}}, record.lights = 2, record.warnings = {"a warning"};
  record.light_kinds.emitting_materials = 1, record.light_kinds.of_kind[0] = 2;
  record.changes = "lights only", record.exposure = Exposure{0.5F, -2.0F, 4.0F};
  EffectPlan plan;
  plan.called_for = {Effect::direct, Effect::glossy_chain}, plan.simulated = {Effect::direct};
  plan.missing = {Effect::glossy_chain}, plan.skipped = {{Effect::environment, "no environment light"}}, plan.max_bounces = 3;
  record.methods = {{"one", plan, "C.{0,1}[LOB]", false, std::nullopt}, {"other", {}, "", true, "it cannot"}};
  return record;
}

StudyRunRecord run(const std::string& id) {
  StudyRunRecord run{id, "a label", "box", "meshless", {{"levels", std::int64_t{4}}, {"radius", 1.0}}, {}, {}, "runs/" + id};
  run.process.status = RunStatus::refused, run.process.exit_code = 4, run.process.error = ErrorCode::refused;
  run.process.message = "refused: it cannot", run.process.wall_seconds = 0.5;
  return run;
}

StudyRecord study_record() {
  StudyRecord record;
  record.name = "quick", record.origin = {"1.0", "c0ffee", {"cpu", "os", "g++", "Release", 2, 1024}};
  record.created = "2026-01-02T03:04:05Z", record.seed = 3, record.threads = 2, record.jobs = 4;
  record.study = std::make_shared<const nlohmann::json>(nlohmann::json{{"gibench_study", 1}, {"scenes", {"box"}}});
  record.scenes = {{"box", "box.scene.json", {}, analysis(), "main", Exposure{}, std::array{64, 48}, "references/box", ""},
                   {"dark", "dark.scene.json", {}, analysis(), {}, {}, {}, {}, "no reference: cancelled"},
                   {"sibenik", "sibenik.scene.json", "its model is not on GIBENCH_PATH", {}, {}, {}, {}, {}, ""}};
  record.runs = {run("box.meshless")};
  record.relights = {run("box.relight")};
  record.relights.front().lights = "box.lights.json";
  return record;
}

TEST(CheckRecord, IsReadAsItWasWritten) {
  const auto written = to_json(check_record());
  const CheckRecord read = check_record_of(written);
  EXPECT_EQ(to_json(read).dump(2), written.dump(2));
  EXPECT_EQ(read.analysis.geometry.bounds_max, Vec3d(1.0, 2.0, 3.0));
  EXPECT_EQ(read.analysis.effects[0].effect, Effect::direct);
  EXPECT_EQ(read.methods[0].plan.missing, EffectSet{Effect::glossy_chain});
  EXPECT_EQ(read.methods[1].refusal, "it cannot");
  EXPECT_EQ(read.light_kinds, check_record().light_kinds);
}

TEST(StudyRecord, IsReadAsItWasWritten) {
  const test::ScratchFolder folder;
  const auto written = to_json(study_record());
  write_file_atomically(folder / manifest_file, written.dump(2));
  const StudyRecord read = read_study_record(folder / manifest_file);
  EXPECT_EQ(to_json(read).dump(2), written.dump(2));
  EXPECT_EQ(read.scenes[0].analysis->bounce_bound.most, 21);
  EXPECT_FALSE(read.scenes[2].analysis.has_value());
  EXPECT_EQ(read.runs[0].parameters, run("").parameters) << "with their types";
  EXPECT_EQ(read.runs[0].process.error, ErrorCode::refused);
  EXPECT_EQ(read.relights[0].lights, "box.lights.json");
}

TEST(StudyRecord, WhatIsNoneIsRefusedByName) {
  const test::ScratchFolder folder;
  for (
      const std::string text :
      {"[1]", "{}", R"({"gibench_study": 2})", R"({"gibench_study": 1, "runs": 7})", R"({"gibench_study": 1, "runs": [7]})",
       R"({"gibench_study": 1, "scenes": {"a": 1}})", R"({"gibench_study": 1, "scenes": [{"file": "a"}]})",
       R"({"gibench_study": 1, "runs": [{"id": 3}]})",
       R"({"gibench_study": 1, "scenes": [{"name": "a", "key": "k", "effects": [{"effect": "magic", "called_for": true, "evidence": ""}]}]})"}) {
    write_file_atomically(folder / manifest_file, text);
    try {
      read_study_record(folder / manifest_file);
      ADD_FAILURE() << "it was taken: " << text;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("manifest.json: is not a study manifest")) << text;
    }
  }
}

TEST(StudyRecord, OfLittleIsRead) {
  const test::ScratchFolder folder;
  write_file_atomically(
      folder / manifest_file,
      std::string(R"({"gibench_study": 1, "runs": [{"id": "a", "scene": "s", "method": "m", "status": "magic"}]})"));
  const StudyRecord read = read_study_record(folder / manifest_file);
  ASSERT_EQ(read.runs.size(), 1U);
  EXPECT_EQ(read.runs[0].label, "a");
  EXPECT_EQ(read.runs[0].folder, "runs/a");
  EXPECT_EQ(read.runs[0].process.status, RunStatus::failed);
  EXPECT_THAT(read.runs[0].process.message, HasSubstr("unknown status 'magic'"));
}

}  // namespace
}  // namespace gibench
