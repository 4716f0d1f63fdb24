/// A store that came with the program: packed, found where the user's own has nothing, never written to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;
namespace fs = std::filesystem;

const std::string with_packed = "export GIBENCH_REFERENCES=packed;";

std::vector<std::string> call(std::vector<std::string> verb, const std::vector<std::string>& more = {}) {
  for (const char* argument : {"--surface-samples", "64", "--pixel-samples", "1", "--json"}) verb.emplace_back(argument);
  verb.insert(verb.end(), more.begin(), more.end());
  return verb;
}

/// The room's reference in the store `packed` and nowhere else.
nlohmann::ordered_json make_packed(const Workshop& shop) {
  const auto made = shop.gibench(call({"reference", "room.scene.json"}, {"--samples", "64", "--picture-samples", "16",
                                                                         "--references", "own", "--packed", "packed"}));
  EXPECT_EQ(made.status, 0) << made.error;
  fs::remove_all(shop / "own");
  return made.json();
}

fs::path packed_folder(const Workshop& shop) { return fs::directory_iterator(shop / "packed")->path(); }

TEST(ShippedReference, HasItsPicturesSamplesApart) {
  const Workshop shop;
  const auto made = make_packed(shop);
  EXPECT_EQ(made["samples_per_replica"], 64);
  EXPECT_EQ(made["image_samples_per_replica"], 16);
  EXPECT_GT(made["image_relative_standard_error"].get<double>(), made["surface_relative_standard_error"].get<double>());
}

TEST(ShippedReference, IsFoundByRunWhereTheOwnStoreHasNone) {
  const Workshop shop;
  make_packed(shop);
  const std::vector<std::string> run = call({"run", "room.scene.json", "--method", "pathtracer", "--references", "own"});
  const auto found = shop.gibench(run, with_packed).json();
  EXPECT_TRUE(found.contains("errors")) << found["warnings"];
  EXPECT_EQ(found["reference"]["samples_per_replica"], 64);
  EXPECT_FALSE(shop.has("own"));
  EXPECT_FALSE(shop.gibench(run, "export GIBENCH_REFERENCES=;").json().contains("errors"));
  EXPECT_EQ(shop.gibench(call({"run", "room.scene.json", "--method", "pathtracer", "--reference", "own"}), with_packed).status, 2)
      << "a store that is named is the only one asked";
}

TEST(ShippedReference, IsTakenByReferenceAndExtendedInTheOwnStore) {
  const Workshop shop;
  const auto made = make_packed(shop);
  const auto shipped = fs::last_write_time(packed_folder(shop) / "meta.json");
  const auto taken =
      shop.gibench(call({"reference", "room.scene.json"}, {"--samples", "16", "--references", "own"}), with_packed).json();
  EXPECT_EQ(taken["samples_per_replica"], 64) << "nothing was made";
  EXPECT_EQ(taken["seconds"], made["seconds"]);
  const auto more =
      shop.gibench(call({"reference", "room.scene.json"}, {"--samples", "128", "--references", "own"}), with_packed).json();
  EXPECT_EQ(more["samples_per_replica"], 128);
  EXPECT_FALSE(more.contains("image_samples_per_replica")) << "pixels caught up";
  EXPECT_LT(more["surface_relative_standard_error"].get<double>(), made["surface_relative_standard_error"].get<double>());
  EXPECT_EQ(fs::last_write_time(packed_folder(shop) / "meta.json"), shipped) << "it is never written to";
}

TEST(ShippedReference, IsTakenByAStudy) {
  const Workshop shop;
  make_packed(shop);
  shop.write("small.study.json", {{"gibench_study", 1},
                                  {"name", "small"},
                                  {"scenes", {"room.scene.json"}},
                                  {"methods", {{{"method", "pathtracer"}, {"parameters", {{"samples", 4}}}}}},
                                  {"reference", {{"samples", 16}}},
                                  {"surface_samples", 64},
                                  {"pixel_samples", 1}});
  const Outcome done = shop.gibench({"study", "small.study.json", "--out", "out"}, with_packed);
  EXPECT_EQ(done.status, 0) << done.error;
  EXPECT_EQ(shop.read_json("out/references/room/reference.json")["samples_per_replica"], 64);
  EXPECT_TRUE(shop.read_json("out/runs/room.pathtracer/result.json").contains("errors"));
}

}  // namespace
}  // namespace gibench::test
