#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <system_error>
#include <thread>

#include "tests/bench/app/small_study.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

TEST(Study, RunsEverythingAndWritesTheManifest) {
  const Workshop shop;
  const Outcome outcome = study(shop, small_study());
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json manifest = shop.read_json("out/manifest.json");
  EXPECT_EQ(manifest["gibench_study"], 1);
  EXPECT_EQ(manifest["name"], "small");
  for (const char* key : {"version", "commit", "machine", "created", "seed", "threads", "study"})
    EXPECT_TRUE(manifest.contains(key)) << key;
  ASSERT_EQ(manifest["scenes"].size(), 1U);
  EXPECT_EQ(manifest["scenes"][0]["name"], "room");
  EXPECT_EQ(manifest["scenes"][0]["resolution"], (std::vector<int>{8, 8}));
  EXPECT_TRUE(manifest["scenes"][0]["exposure"].contains("value"));
  ASSERT_EQ(manifest["runs"].size(), 2U);
  for (const Json& run : manifest["runs"]) {
    EXPECT_EQ(run["status"], "done");
    EXPECT_EQ(run["exit_code"], 0);
    EXPECT_GT(run["peak_bytes"].get<std::uint64_t>(), 1000000U);
    const auto folder = "out/" + run["folder"].get<std::string>();
    for (const char* file : {"/result.json", "/image.exr", "/preview.png", "/log.txt"})
      EXPECT_TRUE(shop.has(folder + file)) << file;
    EXPECT_TRUE(shop.read_json(folder + "/result.json").contains("errors"));
  }
  EXPECT_EQ(run_of(manifest, "room.pathtracer-samples=4")["parameters"]["samples"], 4);
  EXPECT_TRUE(shop.has("out/references/room/reference.exr"));
  EXPECT_TRUE(shop.has("out/references/room/reference.json"));
  for (const auto& entry : std::filesystem::directory_iterator(shop / "out"))
    EXPECT_THAT(entry.path().filename(), testing::AnyOf("manifest.json", "runs", "references")) << "nothing is left over";
}

TEST(Study, RunsWithSeveralSeedsWhereItSaysSo) {
  const Workshop shop;
  Json several = small_study({1});
  several["method_seeds"] = 3;
  ASSERT_EQ(study(shop, several).status, 0);
  const std::string folder = "out/runs/room.pathtracer-samples=1/";
  EXPECT_EQ(shop.read_json(folder + "result.json")["method_seeds"], (std::vector<int>{1, 2, 3}));
  EXPECT_TRUE(shop.read_json(folder + "run.json")["files"].contains("pairs.cbor"));
  ASSERT_EQ(study(shop, small_study({1})).status, 0);
  EXPECT_FALSE(shop.read_json(folder + "result.json").contains("method_seeds")) << "another number of seeds runs again";
  several["method_seeds"] = 65;
  expect_bad_input(study(shop, several), {"method_seeds"});
}

TEST(Study, ASecondCallKeepsWhatIsFinishedAndDoesTheRest) {
  const Workshop shop;
  ASSERT_EQ(study(shop, small_study({1})).status, 0);
  const std::string first = shop.read("out/runs/room.pathtracer-samples=1/result.json");
  const Outcome second = study(shop, small_study({1, 2}));
  ASSERT_EQ(second.status, 0) << second.error;
  EXPECT_EQ(shop.read("out/runs/room.pathtracer-samples=1/result.json"), first);
  EXPECT_THAT(second.error, testing::Not(HasSubstr("room.pathtracer-samples=1 ")));
  EXPECT_TRUE(shop.has("out/runs/room.pathtracer-samples=2/result.json"));
  ASSERT_EQ(study(shop, small_study({1, 2}), {"--force"}).status, 0);
  EXPECT_NE(shop.read("out/runs/room.pathtracer-samples=1/result.json"), first);
}

/// The error that is aimed at is then that of the surface samples: one path less for each pixel would not do for both.
TEST(Study, PixelsOfAReferenceMayHaveFewerPaths) {
  const Workshop shop;
  Json json = small_study({1});
  json["reference"] = {{"samples", 4096}, {"picture_samples", 4}, {"target_error", 0.05}};
  ASSERT_EQ(study(shop, json).status, 0);
  const Json reference = shop.read_json("out/runs/room.pathtracer-samples=1/result.json")["reference"];
  EXPECT_EQ(reference["image_samples_per_replica"], 4);
  EXPECT_GT(reference["samples_per_replica"], 4);
  EXPECT_LT(reference["samples_per_replica"], 4096);
  EXPECT_LE(reference["surface_relative_standard_error"], 0.05);
  EXPECT_GT(reference["image_relative_standard_error"], 0.05);
}

TEST(Study, AnotherSceneOrABetterReferenceRunsAgain) {
  const Workshop shop;
  const std::string record = "out/runs/room.pathtracer-samples=1/result.json";
  ASSERT_EQ(study(shop, small_study({1})).status, 0);
  const Json before = shop.read_json(record);
  EXPECT_EQ(before["reference"]["samples"], 128);
  Json better = small_study({1});
  better["reference"]["samples"] = 32;
  ASSERT_EQ(study(shop, better).status, 0);
  const Json against_better = shop.read_json(record);
  EXPECT_EQ(against_better["reference"]["samples"], 256);
  EXPECT_NE(against_better["errors"], before["errors"]);
  shop.write("room.scene.json", room_scene(0.25));
  ASSERT_EQ(study(shop, better).status, 0);
  const Json in_the_dark = shop.read_json(record);
  EXPECT_NE(in_the_dark["reference"]["key"], before["reference"]["key"]);
  EXPECT_NE(in_the_dark["errors"], against_better["errors"]);
  const std::string text = shop.read(record);
  ASSERT_EQ(study(shop, better).status, 0);
  EXPECT_EQ(shop.read(record), text) << "nothing changed since";
}

TEST(Study, ADryRunListsTheRunsAndWritesNothing) {
  const Workshop shop;
  const Outcome outcome = study(shop, small_study(), {"--dry-run"});
  EXPECT_EQ(outcome.out, "room.pathtracer-samples=1\nroom.pathtracer-samples=4\n");
  EXPECT_FALSE(shop.has("out"));
  EXPECT_EQ(study(shop, small_study(), {"--dry-run", "--json"}).json().size(), 2U);
}

TEST(Study, OneThatComesWithTheProgramIsFoundByItsName) {
  const Workshop shop;
  const Outcome listed = shop.gibench({"study", "quick", "--dry-run"});
  EXPECT_EQ(listed.status, 0) << listed.error;
  EXPECT_THAT(listed.out, HasSubstr("cornell-box.meshless\n"));
  expect_bad_input(shop.gibench({"study", "quicker", "--dry-run"}), {"quicker"});
}

TEST(Study, ATimeOutIsAResultAndIsKept) {
  const Workshop shop;
  Json json = small_study({1, 50000000});
  json["time_limit_seconds"] = 2;
  json.erase("reference");
  ASSERT_EQ(study(shop, json).status, 0);
  const Json manifest = shop.read_json("out/manifest.json");
  EXPECT_EQ(run_of(manifest, "room.pathtracer-samples=1")["status"], "done");
  const Json stopped = run_of(manifest, "room.pathtracer-samples=50000000");
  EXPECT_EQ(stopped["status"], "timed_out");
  EXPECT_THAT(stopped["message"].get<std::string>(), HasSubstr("2 s"));
  EXPECT_GT(stopped["peak_bytes"].get<std::uint64_t>(), 1000000U);
  EXPECT_FALSE(shop.has("out/" + stopped["folder"].get<std::string>() + "/result.json"));
  const auto start = std::chrono::steady_clock::now();
  EXPECT_THAT(study(shop, json).error, testing::Not(HasSubstr("50000000")));
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
}

TEST(Study, ACrashIsAResultAndIsTriedAgain) {
  const Workshop shop;
  Json json = small_study({1, 50000000});
  json.erase("reference");
  // The system ends a process after one second of work with SIGXCPU: a crash as good as any.
  const Outcome outcome = study(shop, json, {}, "ulimit -S -t 1;");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, HasSubstr("gibench: small: not done: room.pathtracer-samples=50000000 crashed: "));
  EXPECT_THAT(outcome.out, HasSubstr("1 crashed, 1 done"));
  const Json crashed = run_of(shop.read_json("out/manifest.json"), "room.pathtracer-samples=50000000");
  EXPECT_EQ(crashed["status"], "crashed");
  EXPECT_THAT(crashed["message"].get<std::string>(), HasSubstr("CPU time limit exceeded"));
  EXPECT_FALSE(crashed.contains("exit_code"));
  EXPECT_THAT(study(shop, json, {}, "ulimit -S -t 1;").error, HasSubstr("samples=50000000 crashed"));
}

TEST(Study, ARunOverItsMemoryLimitIsStopped) {
  const Workshop shop;
  Json json = small_study({50000000});
  json.erase("reference");
  json["memory_limit_mb"] = 2;
  EXPECT_EQ(study(shop, json).status, 4);
  const Json run = shop.read_json("out/manifest.json")["runs"][0];
  EXPECT_EQ(run["status"], "failed");
  EXPECT_THAT(run["message"].get<std::string>(), HasSubstr("memory limit"));
}

TEST(Study, ASceneWhoseModelsAreMissingIsSkippedWithOneLine) {
  const Workshop shop;
  Json lacking = room_scene();
  lacking["objects"].push_back({{"name", "statue"}, {"material", "wall"}, {"file", "statue-nowhere.obj"}});
  shop.write("statues.scene.json", lacking);
  Json json = small_study({1});
  json["scenes"] = {"statues.scene.json", "room.scene.json"};
  const Outcome outcome = study(shop, json);
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("skipped statues: "));
  const Json manifest = shop.read_json("out/manifest.json");
  EXPECT_THAT(manifest["scenes"][0]["skipped"].get<std::string>(), HasSubstr("statue-nowhere.obj"));
  EXPECT_EQ(run_of(manifest, "statues.pathtracer-samples=1")["status"], "skipped");
  EXPECT_EQ(run_of(manifest, "room.pathtracer-samples=1")["status"], "done");
}

void expect_all_done(const Json& manifest) {
  for (const Json& run : manifest["runs"]) EXPECT_EQ(run["status"], "done");
}

TEST(Study, ShardsShareTheRunsAndEndWithTheWholeManifest) {
  const Workshop shop;
  ASSERT_EQ(study(shop, small_study(), {"--shard", "0/2"}).status, 0);
  EXPECT_EQ(run_of(shop.read_json("out/manifest.json"), "room.pathtracer-samples=4")["message"], "not run yet");
  ASSERT_EQ(study(shop, small_study(), {"--shard", "1/2"}).status, 0);
  expect_all_done(shop.read_json("out/manifest.json"));
}

TEST(Study, RunsAtOnceGiveTheSameResults) {
  const Workshop one_by_one, at_once;
  ASSERT_EQ(study(one_by_one, small_study({1, 2, 4})).status, 0);
  ASSERT_EQ(study(at_once, small_study({1, 2, 4}), {"--jobs", "3"}).status, 0);
  const Json answers = answers_in(one_by_one, "out");
  ASSERT_EQ(answers.size(), 3U);
  EXPECT_EQ(answers_in(at_once, "out"), answers);
}

/// Processes that work in a folder.
int processes_in(const std::filesystem::path& folder) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::error_code gone;
    const std::filesystem::path works_in = std::filesystem::read_symlink(entry.path() / "cwd", gone);
    if (!gone && works_in == folder) ++count;
  }
  return count;
}

/// Kills the study in its second run, and gives what was there then.
TEST(Study, KilledItKeepsFinishedRunsAndLeavesNoChildren) {
  const Workshop shop;
  const Outcome killed =
      study(shop, small_study({1, 50000000}), {},
            "(while [ ! -e out/runs/room.pathtracer-samples=50000000.new.partial ]; do sleep 0.05; done; kill -KILL $$) &");
  EXPECT_EQ(killed.status, 128 + SIGKILL);
  const auto patience = std::chrono::steady_clock::now() + std::chrono::seconds(60);
  const std::filesystem::path folder = std::filesystem::canonical(shop.path());
  while (processes_in(folder) > 0 && std::chrono::steady_clock::now() < patience)
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(processes_in(folder), 0) << "the run of the killed study goes on";
  const std::string first = shop.read("out/runs/room.pathtracer-samples=1/result.json");
  EXPECT_TRUE(nlohmann::json::accept(first));
  EXPECT_FALSE(shop.has("out/runs/room.pathtracer-samples=50000000"));
  EXPECT_TRUE(nlohmann::json::accept(shop.read("out/manifest.json")));
  const Outcome resumed = study(shop, small_study({1, 2}));
  EXPECT_EQ(resumed.status, 0) << resumed.error;
  EXPECT_EQ(shop.read("out/runs/room.pathtracer-samples=1/result.json"), first);
}

TEST(Study, InterruptedItStopsItsRunAndSaysSo) {
  const Workshop shop;
  Json json = small_study({1, 50000000});
  json.erase("reference");
  const Outcome outcome =
      study(shop, json, {},
            "(while [ ! -e out/runs/room.pathtracer-samples=1/run.json ]; do sleep 0.05; done; sleep 0.4; kill -INT $$) &");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, HasSubstr("cancelled; finished runs kept in out: 1 of 2; the same command does the rest"));
  EXPECT_FALSE(shop.has("out/runs/room.pathtracer-samples=50000000"));
  EXPECT_EQ(run_of(shop.read_json("out/manifest.json"), "room.pathtracer-samples=1")["status"], "done");
}

TEST(Study, InterruptedAgainItCountsTheRunsOfBefore) {
  const Workshop shop;
  Json json = small_study({1, 2, 50000000});
  json.erase("reference");
  const std::string interrupt =
      "(while [ ! -e out/runs/room.pathtracer-samples=50000000.new.partial ]; do sleep 0.05; done; kill -INT $$) &";
  const std::string kept = "cancelled; finished runs kept in out: 2 of 3; the same command does the rest";
  EXPECT_THAT(study(shop, json, {}, interrupt).error, HasSubstr(kept));
  const std::string first = shop.read("out/runs/room.pathtracer-samples=1/run.json");
  EXPECT_THAT(study(shop, json, {}, interrupt).error, HasSubstr(kept));
  EXPECT_EQ(shop.read("out/runs/room.pathtracer-samples=1/run.json"), first);
}

TEST(Study, InterruptedAtItsReferenceItSaysWhatIsKept) {
  const Workshop shop;
  Json json = small_study();
  json["reference"] = {{"samples", 1000000}};
  const Outcome outcome = study(shop, json, {}, "(while [ ! -e out/references/store ]; do sleep 0.05; done; kill -INT $$) &");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, HasSubstr("cancelled; runs in out that were finished before are kept, and references"));
}

TEST(Study, ANameThatIsNearIsSuggested) {
  expect_bad_input(Workshop().gibench({"study", "quikc", "--dry-run"}), {"quikc", "did you mean \"quick\"?", "studies:", "full"});
}

TEST(Study, WrongStudiesAreToldBeforeAnythingRuns) {
  const Workshop shop;
  const auto with = [&](const std::string& pointer, const Json& value) {
    Json json = small_study();
    json[Json::json_pointer(pointer)] = value;
    return study(shop, json);
  };
  expect_bad_input(with("/colour", 1), {"small.study.json: $", "colour"});
  expect_bad_input(with("/gibench_study", 2), {"$.gibench_study"});
  expect_bad_input(with("/scenes", Json::array()), {"$.scenes"});
  expect_bad_input(with("/scenes/0", "nowhere"), {"$.scenes[0]", "nowhere"});
  expect_bad_input(with("/methods/0/method", "magic"), {"$.methods[0].method", "magic", "known: pathtracer"});
  expect_bad_input(with("/methods/0/sweep", {{"smaples", {1}}}), {"$.methods[0].sweep", "smaples", "known:"});
  expect_bad_input(with("/methods/0/sweep/samples/1", "many"), {"$.methods[0].sweep", "samples=many"});
  expect_bad_input(with("/methods/0/parameters", {{"samples", 0}}), {"$.methods[0].parameters", "samples=0"});
  expect_bad_input(with("/methods/1", {{"method", "pathtracer"}, {"sweep", {{"samples", {4}}}}}),
                   {"$.methods[1]", "twice", "label"});
  expect_bad_input(with("/pixel_samples", 5), {"$.pixel_samples", "square"});
  expect_bad_input(with("/time_limit_seconds", -1), {"$.time_limit_seconds"});
  expect_bad_input(with("/scenes/1", "room.scene.json"), {"$.scenes[1]", "already"});
  shop.write("broken.scene.json", std::string("{"));
  expect_bad_input(with("/scenes/0", "broken.scene.json"), {"broken.scene.json"});
  EXPECT_FALSE(shop.has("out/runs/room.pathtracer-samples=1"));
}

TEST(Study, AFolderOfSomethingElseIsLeftAlone) {
  const Workshop shop;
  shop.write("out/notes.txt", std::string("mine"));
  expect_bad_input(study(shop, small_study()), {"out", "holds no study"});
  EXPECT_EQ(shop.read("out/notes.txt"), "mine");
  shop.write("small.study.json", small_study());
  expect_bad_input(shop.gibench({"study", "small.study.json"}), {"--out"});
  expect_bad_input(shop.gibench({"study", "small.study.json", "--out", "room.scene.json/out"}), {"room.scene.json"});
}

/// The small study with its room relit on the way.
Json relit_study() {
  Json json = small_study({1});
  json["pictures"] = false;
  json["relights"] = {{{"scene", "room"},
                       {"lights", "path.json"},
                       {"method", "spectral"},
                       {"label", "relit"},
                       {"parameters", {{"vertices", 200}, {"rays", 64}, {"basis_functions", 50}}},
                       {"reference_samples", 4}}};
  return json;
}

TEST(Study, RelightsAndKeepsWhatItRelit) {
  const Workshop shop;
  shop.write(
      "path.json",
      Json{{"gibench_light_path", 1}, {"frames", 2}, {"switches", {{{"at", 0.5}, {"material", "wall"}, {"albedo", 0.2}}}}});
  const Outcome outcome = study(shop, relit_study());
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json manifest = shop.read_json("out/manifest.json");
  ASSERT_EQ(manifest["relights"].size(), 1U);
  const Json& relight = manifest["relights"][0];
  EXPECT_EQ(relight["status"], "done") << relight;
  EXPECT_EQ(relight["label"], "relit");
  const std::string file = "out/" + relight["folder"].get<std::string>() + "/relight.json";
  EXPECT_EQ(shop.read_json(file)["frames"].size(), 2U);
  EXPECT_TRUE(shop.read_json(file)["summary"].contains("frames_that_pay_for_prepare"));
  const std::string first = shop.read(file);
  ASSERT_EQ(study(shop, relit_study()).status, 0);
  EXPECT_EQ(shop.read(file), first);
  shop.write("path.json", Json{{"gibench_light_path", 1}, {"frames", 3}});
  ASSERT_EQ(study(shop, relit_study()).status, 0);
  EXPECT_EQ(shop.read_json(file)["frames"].size(), 3U) << "other moving lights are another relighting";
}

TEST(Study, WithoutPicturesHasErrorsAtTheSurfaceAlone) {
  const Workshop shop;
  Json json = small_study({1});
  json["pictures"] = false;
  ASSERT_EQ(study(shop, json).status, 0);
  const std::string folder = "out/runs/room.pathtracer-samples=1";
  EXPECT_FALSE(shop.has(folder + "/image.exr"));
  const Json errors = shop.read_json(folder + "/result.json")["errors"]["indirect"];
  EXPECT_TRUE(errors.contains("surface"));
  EXPECT_FALSE(errors.contains("image"));
}

TEST(Study, AMethodRunsOnItsScenesAlone) {
  const Workshop shop;
  Json json = small_study();
  json["scenes"].push_back("furnace.scene.json");
  shop.write("furnace.scene.json", furnace_scene());
  json["methods"].push_back({{"method", "meshless"}, {"scenes", {"furnace"}}});
  const Outcome listed = study(shop, json, {"--dry-run"});
  EXPECT_EQ(listed.out,
            "room.pathtracer-samples=1\nroom.pathtracer-samples=4\nfurnace.pathtracer-samples=1\nfurnace.pathtracer-samples=4\n"
            "furnace.meshless\n");
  json["methods"][1]["scenes"] = {"cellar"};
  expect_bad_input(study(shop, json), {"$.methods[1].scenes[0]", "cellar", "room, furnace"});
}

TEST(Study, BadRelightsNamePlaceAndMend) {
  const Workshop shop;
  shop.write("path.json", Json{{"gibench_light_path", 1}});
  const auto with = [](const char* key, const Json& value) {
    Json json = relit_study();
    json["relights"][0][key] = value;
    return json;
  };
  expect_bad_input(study(shop, with("scene", "attic")), {"$.relights[0].scene", "attic", "room"});
  expect_bad_input(study(shop, with("lights", "no.json")), {"$.relights[0].lights", "no.json"});
  expect_bad_input(study(shop, with("method", "magic")), {"$.relights[0].method", "magic", "spectral"});
  expect_bad_input(study(shop, with("parameters", {{"verts", 3}})), {"$.relights[0].parameters", "verts"});
  Json twice = relit_study();
  twice["relights"].push_back(twice["relights"][0]);
  expect_bad_input(study(shop, twice), {"$.relights[1]", "appears twice"});
}

}  // namespace
}  // namespace gibench::test
