#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "bench/record/checksums.h"
#include "bench/record/pair_record.h"
#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

const std::vector<std::string> small{"--surface-samples", "64", "--pixel-samples", "1"};

std::vector<std::string> with(std::vector<std::string> arguments, const std::vector<std::string>& more) {
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Run, WritesARecordAPictureAndALog) {
  const Workshop shop;
  const Outcome outcome = shop.gibench(with(
      {"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=4", "--reference", "none", "--out", "out"}, small));
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  for (const char* file : {"out/result.json", "out/image.exr", "out/preview.png", "out/log.txt"})
    EXPECT_TRUE(shop.has(file)) << file;
  EXPECT_FALSE(shop.has("out.partial"));
  const auto result = shop.read_json("out/result.json");
  EXPECT_EQ(result["scene"], "room");
  EXPECT_EQ(result["method"], "pathtracer");
  EXPECT_EQ(result["parameters"]["samples"], 4);
  EXPECT_EQ(result["seed"], 1);
  EXPECT_GE(result["threads"].get<int>(), 1);
  for (const char* stage : {"load", "prepare", "light", "shade", "shade_surface", "shade_image"})
    EXPECT_TRUE(result["seconds"].contains(stage)) << stage;
  EXPECT_GT(result["memory"]["peak_bytes"].get<std::uint64_t>(), 0U);
  EXPECT_GT(result["counters"]["occlusion_rays"].get<std::uint64_t>(), 0U);
  EXPECT_EQ(result["effects"]["called_for"], (std::vector<std::string>{"direct", "diffuse_indirect", "occlusion", "colour"}));
  EXPECT_EQ(result["light_paths"], "C.*[LOB]");
  EXPECT_TRUE(result["effects"]["missing"].empty());
  EXPECT_TRUE(result["termination"].is_string());
  EXPECT_FALSE(result.contains("errors")) << "what was not measured is absent";
  EXPECT_FALSE(result.contains("reference"));
}

TEST(Run, APresetIsOverriddenBySettings) {
  const Workshop shop;
  const Outcome outcome =
      shop.gibench(with({"run", "room.scene.json", "--method", "meshless", "--preset", "paper", "--set", "levels=1", "--set",
                         "rays=16", "--set", "coarsest_rays=16", "--reference", "none", "--json"},
                        small));
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto parameters = outcome.json()["parameters"];
  EXPECT_EQ(parameters["levels"], 1);
  EXPECT_EQ(parameters["rays"], 16);
  EXPECT_EQ(parameters["noise_guard"], 0.0);
  EXPECT_EQ(parameters["direct"], "basis");
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "meshless", "--preset", "papers"}),
                   {"--preset", "\"papers\"", "paper"});
}

TEST(Run, SplitsItsErrorWhereItLacksLightPaths) {
  const Workshop shop;
  const std::vector<std::string> reference = with({"reference", "room.scene.json", "--samples", "64", "--quiet"}, small);
  ASSERT_EQ(shop.gibench(reference).status, 0);
  const auto arguments = with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=64", "--effects",
                               "direct,environment", "--out", "out", "--force"},
                              small);
  const Outcome lacking = shop.gibench(arguments);
  ASSERT_EQ(lacking.status, 0) << lacking.error;
  EXPECT_THAT(lacking.error, HasSubstr("--light-paths 'C.{0,1}[LOB]'"));
  EXPECT_FALSE(shop.read_json("out/result.json")["error_split"].contains("model"));

  ASSERT_EQ(shop.gibench(with(reference, {"--light-paths", "C.{0,1}[LOB]"})).status, 0);
  ASSERT_EQ(shop.gibench(arguments).status, 0);
  const auto result = shop.read_json("out/result.json");
  const auto& split = result["error_split"];
  EXPECT_FALSE(split["complete"].get<bool>());
  EXPECT_EQ(split["reference"]["path_class"], "C.{0,1}[LOB]");
  const auto& model = split["model"]["indirect"]["surface"]["relative_rmse"];
  EXPECT_GT(model["value"].get<double>(), 1.0) << "all of the indirect light, against its mean";
  EXPECT_TRUE(model.contains("ci95") && model.contains("noise_floor"));
  EXPECT_LT(split["model"]["direct"]["surface"]["rmse"]["value"].get<double>(), 1e-6) << "the two share their random numbers";
  EXPECT_LT(split["discretisation"]["total"]["surface"]["rmse"]["value"].get<double>(),
            result["errors"]["total"]["surface"]["rmse"]["value"].get<double>());

  const Outcome all =
      shop.gibench(with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=16", "--out", "all"}, small));
  ASSERT_EQ(all.status, 0);
  EXPECT_TRUE(shop.read_json("all/result.json")["error_split"]["complete"].get<bool>());
}

TEST(Run, TellsItsErrorsBounceByBounceOnRequest) {
  const Workshop shop;
  const std::vector<std::string> reference = with({"reference", "room.scene.json", "--samples", "16", "--quiet"}, small);
  for (const std::string paths : {"", "C.{0,1}[LOB]", "C..{1,1}[LOB]"})
    ASSERT_EQ(shop.gibench(paths.empty() ? reference : with(reference, {"--light-paths", paths})).status, 0);
  const Outcome outcome = shop.gibench(with(
      {"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=16", "--per-bounce", "2", "--out", "out"}, small));
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_THAT(outcome.error, HasSubstr("--light-paths 'C..{2,2}[LOB]'"));
  const auto bounces = shop.read_json("out/result.json")["errors_per_bounce"];
  ASSERT_EQ(bounces.size(), 2U);
  EXPECT_TRUE(bounces[1]["complete"].get<bool>());
  EXPECT_TRUE(bounces[1]["discretisation"]["indirect"]["surface"].contains("relative_rmse"));
}

TEST(Run, APlanThatLeavesNothingIsSaidAndNoError) {
  const Workshop shop;
  const Outcome outcome = shop.gibench(with(
      {"run", "room.scene.json", "--method", "pathtracer", "--effects", "none", "--reference", "none", "--out", "out"}, small));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.error, HasSubstr("nothing to simulate"));
  EXPECT_EQ(shop.read_json("out/result.json")["light_paths"], "C[^.]");
}

TEST(Run, WrongPlansAreTold) {
  const Workshop shop;
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--effects", "magic"}),
                   {"--effects", "'magic'", "known:", "diffuse_indirect"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--light-paths", "C(D"}),
                   {"C(D", "position 4", "expected ')'"});
  expect_bad_input(shop.gibench({"reference", "room.scene.json", "--light-paths", "CX"}), {"position 2", "expected an event"});
  expect_bad_input(
      shop.gibench({"run", "room.scene.json", "--method", "meshless", "--light-paths", "CD*L", "--reference", "none"}),
      {"--light-paths", "meshless"});
}

TEST(Run, WithoutAReferenceItSaysHowToMakeOneAndMakesNone) {
  const Workshop shop;
  const Outcome outcome = shop.gibench(with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=1"}, small));
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.error, HasSubstr("gibench reference room.scene.json"));
  EXPECT_FALSE(shop.has("references"));
}

TEST(Run, NothingIsOverwrittenWithoutForce) {
  const Workshop shop;
  const auto arguments = with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=1", "--reference", "none",
                               "--quiet", "--out", "out"},
                              small);
  ASSERT_EQ(shop.gibench(arguments).status, 0);
  shop.write("out/result.json", std::string("kept"));
  expect_bad_input(shop.gibench(arguments), {"out", "exists", "--force"});
  EXPECT_EQ(shop.read("out/result.json"), "kept");
  EXPECT_EQ(shop.gibench(with(arguments, {"--force"})).status, 0);
  EXPECT_NE(shop.read("out/result.json"), "kept");
  shop.write("mine/notes.txt", std::string("mine"));
  const auto into_mine = with({"run", "room.scene.json", "--method", "pathtracer", "--out", "mine", "--force"}, small);
  expect_bad_input(shop.gibench(into_mine), {"mine", "not made by gibench"});
  EXPECT_EQ(shop.read("mine/notes.txt"), "mine");
}

TEST(Run, AnUnwritableFolderIsToldBeforeTheWork) {
  const Workshop shop;
  expect_bad_input(
      shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--reference", "none", "--out", "room.scene.json/out"}),
      {"room.scene.json/out", "cannot be written"});
}

TEST(Run, WrongChoicesAreTold) {
  const Workshop shop;
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "magic"}), {"magic", "known:", "pathtracer"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--set", "smaples=4"}),
                   {"smaples", "known:", "samples"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=lots"}), {"samples=lots"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples"}), {"name=value"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--camera", "side"}),
                   {"side", "known: main"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--pixel-samples", "3"}), {"square"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--bounces", "-1"}), {"--bounces"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--reference", "nowhere"}),
                   {"nowhere", "gibench reference"});
}

/// Everything in a record that may not depend on the number of threads or the clock.
nlohmann::ordered_json values_of(nlohmann::ordered_json result) {
  for (const char* timed : {"seconds", "memory", "threads", "stages"}) result.erase(timed);
  return result;
}

TEST(Run, TheSameSeedGivesTheSamePictureForAnyNumberOfThreads) {
  const Workshop shop;
  for (const char* threads : {"1", "2"})
    ASSERT_EQ(shop.gibench(with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=4", "--reference", "none",
                                 "--out", std::string("out") + threads, "--threads", threads, "--seed", "7"},
                                small))
                  .status,
              0);
  EXPECT_EQ(values_of(shop.read_json("out1/result.json")), values_of(shop.read_json("out2/result.json")));
  EXPECT_EQ(shop.read("out1/image.exr"), shop.read("out2/image.exr"));
  EXPECT_EQ(shop.read("out1/preview.png"), shop.read("out2/preview.png"));
}

TEST(Run, ErrorsAreTakenAgainstTheStoredReference) {
  const Workshop shop;
  ASSERT_EQ(shop.gibench(with({"reference", "room.scene.json", "--samples", "32"}, small)).status, 0);
  const Outcome outcome =
      shop.gibench(with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=16", "--json"}, small));
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const auto result = outcome.json();
  EXPECT_EQ(result["reference"]["samples"], 32 * 8);
  EXPECT_GT(result["reference"]["relative_standard_error"].get<double>(), 0.0);
  EXPECT_EQ(result["reference"]["path_class"], "C.*[LOB]");
  for (const char* component : {"direct", "indirect", "total"})
    for (const char* domain : {"surface", "image"}) {
      const auto& error = result["errors"][component][domain]["relative_rmse"];
      ASSERT_TRUE(error.is_object()) << component << domain;
      EXPECT_GT(error["value"].get<double>(), 0.0);
      EXPECT_LT(error["value"].get<double>(), 0.5);
      EXPECT_LE(error["ci95"][0].get<double>(), error["ci95"][1].get<double>());
      EXPECT_TRUE(error.contains("noise_floor"));
    }
  EXPECT_TRUE(result["errors"]["total"]["image"].contains("flip"));
}

TEST(Run, SeveralSeedsWidenTheIntervalsAndAreTold) {
  const Workshop shop;
  ASSERT_EQ(shop.gibench(with({"reference", "room.scene.json", "--samples", "32"}, small)).status, 0);
  const std::vector<std::string> arguments =
      with({"run", "room.scene.json", "--method", "meshless", "--set", "levels=2", "--set", "coarsest_samples=50"}, small);
  const auto outcome_of = [&](const std::string& out, const std::vector<std::string>& more) {
    const Outcome outcome = shop.gibench(with(with(arguments, {"--out", out}), more));
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return shop.read_json(out + "/result.json");
  };
  const auto one = outcome_of("one", {"--seed", "5"}), three = outcome_of("three", {"--seed", "5", "--method-seeds", "3"});
  EXPECT_EQ(one["intervals_cover"], (std::vector<std::string>{"reference", "points"}));
  EXPECT_FALSE(one.contains("method_seeds"));
  EXPECT_EQ(three["intervals_cover"], (std::vector<std::string>{"reference", "points", "method_seed"}));
  EXPECT_EQ(three["method_seeds"], (std::vector<int>{5, 6, 7}));
  EXPECT_EQ(three["counters"], one["counters"]) << "the first run alone is measured";
  EXPECT_EQ(shop.read("one/preview.png"), shop.read("three/preview.png"));
  double squares = 0.0;
  for (const char* seed : {"5", "6", "7"}) {
    const auto alone = outcome_of(std::string("seed-") + seed, {"--seed", seed});
    squares += std::pow(alone["errors"]["indirect"]["surface"]["rmse"]["value"].get<double>(), 2);
  }
  const auto& error = three["errors"]["indirect"]["surface"]["rmse"];
  EXPECT_NEAR(error["value"].get<double>(), std::sqrt(squares / 3.0), 1e-6 * error["value"].get<double>());
  EXPECT_GT(error["seed_deviation"].get<double>(), 0.0);
  EXPECT_FALSE(one["errors"]["indirect"]["surface"]["rmse"].contains("seed_deviation"));
  expect_bad_input(shop.gibench(with(arguments, {"--method-seeds", "0"})), {"--method-seeds"});
}

/// Of the path tracer the spread over points holds its own noise.
TEST(Run, ThePathTracersIntervalsCoverItsSeed) {
  const Workshop shop;
  ASSERT_EQ(shop.gibench(with({"reference", "room.scene.json", "--samples", "16"}, small)).status, 0);
  const auto covered = [&](const char* replicates) {
    return shop
        .gibench(with({"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=4", "--set",
                       std::string("replicates=") + replicates, "--json"},
                      small))
        .json()["intervals_cover"];
  };
  for (const char* replicates : {"1", "2"})
    EXPECT_EQ(covered(replicates), (std::vector<std::string>{"reference", "points", "method_seed"})) << replicates;
}

TEST(Run, WithErrorsLeavesWhatComparesThemWithOthers) {
  const Workshop shop;
  ASSERT_EQ(shop.gibench(with({"reference", "room.scene.json", "--samples", "32"}, small)).status, 0);
  for (const char* samples : {"4", "16"})
    ASSERT_EQ(shop.gibench(with({"run", "room.scene.json", "--method", "pathtracer", "--set", std::string("samples=") + samples,
                                 "--out", samples},
                                small))
                  .status,
              0);
  auto result = shop.read_json("4/result.json");
  EXPECT_EQ(result["files"]["pairs.cbor"], checksum_of(shop.read("4/pairs.cbor")));
  const PairRecord coarse = read_pair_record(shop / "4/pairs.cbor"), fine = read_pair_record(shop / "16/pairs.cbor");
  ASSERT_TRUE(can_be_compared(coarse, fine));
  for (const Component component : all_components)
    for (const Domain domain : all_domains) {
      const PairTerms &a = *coarse.terms(component, domain, "rmse"), &b = *fine.terms(component, domain, "rmse");
      EXPECT_EQ(a.parts.size(), 64U) << "as many as points and pixels";
      const double error = result["errors"][to_string(component)][to_string(domain)]["rmse"]["value"].get<double>();
      EXPECT_NEAR(std::sqrt(std::max(0.0, a.value)), error, 1e-9);
      EXPECT_GT(difference_of("rmse", a, b)->value, 0.0) << "a quarter of the paths";
      const PairTerms& relative = *fine.terms(component, domain, "rel_mse(0.01)");
      const double square = result["errors"][to_string(component)][to_string(domain)]["rel_mse(0.01)"]["value"].get<double>();
      EXPECT_NEAR(coarse.terms(component, domain, "rel_mse(0.01)")->value, square, 1e-9);
      EXPECT_TRUE(difference_of("rel_mse(0.01)", *coarse.terms(component, domain, "rel_mse(0.01)"), relative));
    }
}

TEST(Run, AMethodWithoutDirectLightIsCompletedAndTheRecordSaysSo) {
  const Workshop shop;
  const auto result = shop.gibench(with({"run", "room.scene.json", "--method", "meshless", "--reference", "none", "--json",
                                         "--set", "levels=2", "--set", "coarsest_samples=50"},
                                        small))
                          .json();
  EXPECT_EQ(result["completed_by"]["components"], std::vector<std::string>{"direct"});
}

TEST(Run, WithoutLightThereIsNothingToSimulateAndThePictureIsBlack) {
  const Workshop shop;
  auto dark = room_scene();
  dark["materials"]["lamp"]["emission"] = 0.0;
  shop.write("dark.scene.json", dark);
  const auto result =
      shop.gibench(with({"run", "dark.scene.json", "--method", "pathtracer", "--reference", "none", "--json"}, small)).json();
  EXPECT_TRUE(result["effects"]["simulated"].empty());
  EXPECT_EQ(result["effects"]["skipped"].size(), 8U);
  EXPECT_EQ(result["counters"]["occlusion_rays"], 0) << "none is measured too";
  EXPECT_EQ(result["counters"]["closest_hit_rays"], 0);
}

/// The faces of an object the other way round.
void turn_round(Json& object) {
  for (Json& face : object["faces"]) std::reverse(face.begin(), face.end());
}

/// A plate on its floor alone has a front that the camera sees.
TEST(Run, ARoomThatIsInsideOutIsWarnedOf) {
  const Workshop shop;
  Json scene = room_scene();
  turn_round(scene["objects"][0]);
  scene["objects"].push_back({{"name", "plate"},
                              {"material", "wall"},
                              {"vertices", {{0.3, 0.01, 0.2}, {0.3, 0.01, 0.6}, {0.7, 0.01, 0.6}, {0.7, 0.01, 0.2}}},
                              {"faces", {{0, 1, 2, 3}}}});
  shop.write("turned.scene.json", scene);
  const auto run = [&shop](const std::string& name) {
    return shop.gibench({"run", name, "--method", "pathtracer", "--surface-samples", "64", "--pixel-samples", "1"});
  };
  const Outcome turned = run("turned.scene.json"), sound = run("room.scene.json");
  ASSERT_EQ(turned.status, 0) << turned.error;
  EXPECT_THAT(turned.error, HasSubstr("the camera sees mostly black backs of one-sided objects"));
  EXPECT_THAT(turned.error, HasSubstr("most of them of \"room\"): is the model inside out?"));
  EXPECT_THAT(sound.error, testing::Not(HasSubstr("black backs")));
}

TEST(Run, WithNothingButBlackBacksInSightThereIsNothingToAskAbout) {
  const Workshop shop;
  Json scene = room_scene();
  for (Json& object : scene["objects"]) turn_round(object);
  shop.write("turned.scene.json", scene);
  expect_bad_input(shop.gibench({"run", "turned.scene.json", "--method", "meshless", "--surface-samples", "64", "--quiet"}),
                   {"--surface-domain", "no camera sees a surface that light can leave", "inside out"});
}

TEST(Run, InterruptedItLeavesNothingHalfWritten) {
  const Workshop shop;
  const Outcome outcome = shop.gibench(
      {"run", "room.scene.json", "--method", "pathtracer", "--set", "samples=100000", "--reference", "none", "--out", "out"},
      "(sleep 0.7; kill -INT $$) &");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, HasSubstr("cancelled"));
  EXPECT_FALSE(shop.has("out"));
  EXPECT_FALSE(shop.has("out.partial"));
}

}  // namespace
}  // namespace gibench::test
