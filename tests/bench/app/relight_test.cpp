#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "bench/measure/moving_lights.h"
#include "common/scene_io/load.h"
#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using Json = nlohmann::ordered_json;

/// The room with a point light in place of its lamp.
Json point_lit_room() {
  Json scene = room_scene();
  for (auto& [name, material] : scene["materials"].items()) material.erase("emission");
  scene["lights"] = Json::array({{{"type", "point"}, {"position", {0.5, 0.8, 0.5}}, {"intensity", {1, 1, 1}}}});
  return scene;
}

Json brightening_path() {
  const Json keys = Json::array({{{"at", 0}, {"intensity", 1}}, {{"at", 1}, {"intensity", {3, 3, 3}}}});
  return {{"gibench_light_path", 1}, {"frames", 3}, {"lights", Json::array({{{"light", 0}, {"keys", keys}}})}};
}

Json switch_to(double at, const std::string& material, double albedo) {
  return {{"at", at}, {"material", material}, {"albedo", albedo}};
}

Outcome relight(const Workshop& shop, const Json& path, std::vector<std::string> more = {},
                const std::string& scene = "lit.scene.json") {
  shop.write("lit.scene.json", point_lit_room());
  shop.write("path.json", path);
  std::vector<std::string> arguments{"relight", scene,   "--method",           "spectral", "--set",     "vertices=200", "--set",
                                     "rays=64", "--set", "basis_functions=50", "--lights", "path.json", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return shop.gibench(arguments);
}

TEST(Relight, EveryFrameHasItsCostAndItsErrors) {
  const Workshop shop;
  const Outcome outcome = relight(shop, brightening_path(), {"--reference-samples", "16", "--surface-samples", "64"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json json = outcome.json();
  ASSERT_EQ(json["frames"].size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const Json& frame = json["frames"][i];
    EXPECT_DOUBLE_EQ(frame["at"].get<double>(), 0.5 * static_cast<double>(i));
    EXPECT_GT(frame["seconds"]["relight"].get<double>(), 0.0);
    for (const char* component : {"direct", "indirect", "total"}) {
      const double error = frame["errors"][component]["relative_rmse"]["value"].get<double>();
      EXPECT_LT(error, 0.25) << component << " of frame " << i;
    }
  }
  EXPECT_GT(json["summary"]["prepare_seconds"].get<double>(), 0.0);
}

/// What the summary says of path tracing follows from what the frames say.
TEST(Relight, TheSummaryHoldsAFrameAgainstPathTracing) {
  const Workshop shop;
  const Outcome outcome =
      relight(shop, brightening_path(), {"--reference-samples", "256", "--surface-samples", "64", "--frames", "1"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json json = outcome.json();
  const Json &frame = json["frames"][0], &summary = json["summary"], &rmse = frame["errors"]["indirect"]["rmse"];
  ASSERT_TRUE(rmse["resolved"].get<bool>()) << "a mesh of 200 vertices errs more than 2048 paths do";
  EXPECT_EQ(frame["reference"]["paths"], 2048.0);
  // The floor is the noise of the mean of all replicates: another estimate of the same standard error.
  EXPECT_NEAR(frame["reference"]["rmse"].get<double>() / rmse["noise_floor"].get<double>(), 1.0, 0.5);
  const double ratio = frame["reference"]["rmse"].get<double>() / rmse["value"].get<double>();
  const double wanted = std::max(1.0 / 2048.0, ratio * ratio) * frame["reference"]["seconds"].get<double>();
  const double seconds = summary["path_tracing_seconds_at_equal_error"]["value"].get<double>();
  EXPECT_NEAR(seconds / wanted, 1.0, 1e-9);
  const double one = summary["median_seconds"]["relight"].get<double>() + summary["median_seconds"]["shade"].get<double>();
  EXPECT_NEAR(summary["path_tracing_over_frame"]["value"].get<double>() / (seconds / one), 1.0, 1e-9);
  const Json& frames = summary["frames_that_pay_for_prepare"];
  ASSERT_EQ(frames.contains("value"), seconds > one) << "preparing pays where a frame is the faster, and there alone";
  if (seconds <= one) return;
  const double pays = frames["value"].get<double>(), prepare = summary["prepare_seconds"].get<double>();
  EXPECT_GE(pays, 1.0);
  EXPECT_LE(prepare + pays * one, pays * seconds * (1.0 + 1e-12));
  EXPECT_GT(prepare + (pays - 1.0) * one, (pays - 1.0) * seconds) << "one frame less does not pay";
}

/// Compared at fewer points than asked: the errors are those at these points.
TEST(Relight, ComparesAtFewerPointsThanItAsks) {
  const Workshop shop;
  const auto frame = [&](const std::vector<std::string>& points) {
    std::vector<std::string> more{"--reference-samples", "64", "--frames", "1"};
    more.insert(more.end(), points.begin(), points.end());
    const Outcome outcome = relight(shop, brightening_path(), more);
    EXPECT_EQ(outcome.status, 0) << outcome.error;
    return outcome.json()["frames"][0];
  };
  const Json few = frame({"--surface-samples", "64"}), many = frame({"--surface-samples", "6400", "--compared-samples", "64"});
  EXPECT_EQ(many["errors"], few["errors"]);
  EXPECT_EQ(many["reference"]["rmse"], few["reference"]["rmse"]);
}

TEST(Relight, BelowTheNoiseFloorOnlyABoundIsGiven) {
  const Workshop shop;
  shop.write("furnace.scene.json",
             furnace_scene());  // one radiance everywhere: only noise is wrong, far less of it than the reference's
  shop.write("path.json", Json{{"gibench_light_path", 1}, {"frames", 1}});
  const Outcome outcome = shop.gibench({"relight", "furnace.scene.json", "--method", "spectral", "--set", "vertices=200", "--set",
                                        "rays=4096", "--set", "direct_samples=64", "--set", "residual=1e-6", "--set",
                                        "compression_error=0", "--lights", "path.json", "--reference-samples", "4", "--json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json json = outcome.json();
  ASSERT_FALSE(json["frames"][0]["errors"]["indirect"]["rmse"]["resolved"].get<bool>());
  const Json& seconds = json["summary"]["path_tracing_seconds_at_equal_error"];
  EXPECT_FALSE(seconds.contains("value"));
  EXPECT_GT(seconds["ci95"][0].get<double>(), 0.0);
  EXPECT_TRUE(seconds["ci95"][1].is_null());
}

/// A scene whose wall got another BRDF on the way answers as one whose file gives the wall that BRDF.
TEST(Relight, BrdfsSwitchOnTheWay) {
  const Json phong{{"bsdf", "phong"}, {"diffuse", {0.3, 0.3, 0.3}}, {"specular", 0.3}, {"exponent", 8}};
  Json path{{"gibench_light_path", 1}, {"frames", 2}, {"switches", {{{"at", 1}, {"material", "wall"}}}}};
  path["switches"][0].update(phong);
  const std::vector<std::string> compared{"--reference-samples", "16", "--surface-samples", "64"};
  const Workshop switched, fresh;
  const Outcome on_the_way = relight(switched, path, compared);
  ASSERT_EQ(on_the_way.status, 0) << on_the_way.error;
  Json scene = point_lit_room();
  scene["materials"]["wall"] = phong;
  fresh.write("phong.scene.json", scene);
  const Json still{{"gibench_light_path", 1}, {"frames", 1}};
  const Outcome from_the_start = relight(fresh, still, compared, "phong.scene.json");
  ASSERT_EQ(from_the_start.status, 0) << from_the_start.error;
  const Json before = on_the_way.json()["frames"][0], after = on_the_way.json()["frames"][1];
  const Json wanted = from_the_start.json()["frames"][0];
  EXPECT_EQ(after["switched"], Json::array({"wall"}));
  for (const char* component : {"direct", "indirect", "total"})
    EXPECT_EQ(after["errors"][component]["rmse"]["value"], wanted["errors"][component]["rmse"]["value"]) << component;
  EXPECT_NE(after["errors"]["total"]["rmse"]["value"], before["errors"]["total"]["rmse"]["value"]);
}

TEST(Relight, FramesAndOutAreTakenFromTheCall) {
  const Workshop shop;
  const Outcome outcome = relight(shop, brightening_path(), {"--frames", "2", "--out", "frames.json"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  EXPECT_EQ(shop.read_json("frames.json")["frames"].size(), 2U);
}

TEST(Relight, MaterialsSwitchAtTheirTime) {
  const Workshop shop;
  const Json path{{"gibench_light_path", 1},
                  {"frames", 5},
                  {"switches", Json::array({switch_to(0.4, "wall", 0.2), switch_to(0.9, "wall", 0.5)})}};
  const Outcome outcome = relight(shop, path, {"--reference-samples", "16", "--surface-samples", "64"});
  ASSERT_EQ(outcome.status, 0) << outcome.error;
  const Json frames = outcome.json()["frames"];
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(frames[i]["switched"].size(), i == 2 || i == 4 ? 1U : 0U) << i;
    EXPECT_LT(frames[i]["errors"]["indirect"]["relative_rmse"]["value"].get<double>(), 0.25) << i;
  }
}

TEST(Relight, BadPathsNameFilePlaceAndMend) {
  const Workshop shop;
  Json unknown_key = brightening_path(), wrong_light = brightening_path(), late = brightening_path(),
       wrong_kind = brightening_path(), no_material = brightening_path(), bad_albedo = brightening_path();
  unknown_key["lamps"] = Json::array();
  wrong_light["lights"][0]["light"] = 7;
  late["lights"][0]["keys"][0]["at"] = 1, late["lights"][0]["keys"][1]["at"] = 0.5;
  wrong_kind["lights"][0]["keys"][1]["direction"] = {0, -1, 0};
  no_material["switches"] = Json::array({switch_to(0.0, "chalk", 0.5)});
  bad_albedo["switches"] = Json::array({switch_to(0.0, "wall", 1.5)});
  expect_bad_input(relight(shop, unknown_key), {"path.json", "lamps"});
  expect_bad_input(relight(shop, wrong_light), {"path.json", "$.lights[0].light", "no light 7"});
  expect_bad_input(relight(shop, late), {"path.json", "$.lights[0].keys[1].at", "ascending"});
  expect_bad_input(relight(shop, wrong_kind), {"path.json", "$.lights[0].keys[1]", "direction"});
  expect_bad_input(relight(shop, no_material), {"path.json", "$.switches[0].material", "chalk"});
  expect_bad_input(relight(shop, bad_albedo), {"path.json", "$.switches[0].albedo", "1.5"});
}

/// Every file of moving lights beside the scenes is one of the scene that it is named after.
TEST(MovingLights, OfTheScenesAreReadable) {
  namespace fs = std::filesystem;
  int found = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(GIBENCH_SOURCE_DIR "/scenes")) {
    const std::string name = entry.path().filename().string(), ending = ".lights.json";
    if (!name.ends_with(ending)) continue;
    ++found;
    const Scene scene = load_scene(entry.path().parent_path() / (name.substr(0, name.size() - ending.size()) + ".scene.json"));
    EXPECT_GT(read_moving_lights(entry.path(), scene, std::nullopt).size(), 1U) << name;
  }
  EXPECT_GE(found, 3);
}

}  // namespace
}  // namespace gibench::test
