#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;

std::vector<std::string> reference_of(const std::string& scene, const std::vector<std::string>& more) {
  std::vector<std::string> arguments{"reference", scene, "--surface-samples", "64", "--pixel-samples", "1", "--json"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

TEST(Reference, IsMadeOnceAndExtendedWhenMoreIsAskedFor) {
  const Workshop shop;
  const auto first = shop.gibench(reference_of("room.scene.json", {"--samples", "16"})).json();
  EXPECT_EQ(first["samples_per_replica"], 16);
  EXPECT_EQ(first["replicas"], 8);
  const auto again = shop.gibench(reference_of("room.scene.json", {"--samples", "16"})).json();
  EXPECT_EQ(again, first) << "nothing was made anew";
  const auto more = shop.gibench(reference_of("room.scene.json", {"--samples", "64"})).json();
  EXPECT_EQ(more["samples_per_replica"], 64);
  EXPECT_EQ(more["key"], first["key"]);
  EXPECT_GT(more["seconds"].get<double>(), first["seconds"].get<double>());
  EXPECT_LT(more["relative_standard_error"].get<double>(), first["relative_standard_error"].get<double>());
}

TEST(Reference, ExtendedIsAsGoodAsMadeAtOnce) {
  const Workshop shop;
  shop.gibench(reference_of("room.scene.json", {"--samples", "16", "--references", "a"}));
  const auto extended = shop.gibench(reference_of("room.scene.json", {"--samples", "64", "--references", "a"})).json();
  const auto at_once = shop.gibench(reference_of("room.scene.json", {"--samples", "64", "--references", "b"})).json();
  EXPECT_NEAR(extended["relative_standard_error"].get<double>(), at_once["relative_standard_error"].get<double>(),
              1e-4 * at_once["relative_standard_error"].get<double>());
}

TEST(Reference, StopsAtTheTargetError) {
  const Workshop shop;
  const auto made = shop.gibench(reference_of("room.scene.json", {"--target-error", "0.03"})).json();
  EXPECT_LE(made["relative_standard_error"].get<double>(), 0.03);
  const Outcome short_of = shop.gibench(reference_of("room.scene.json", {"--target-error", "0.0001", "--samples", "128"}));
  EXPECT_EQ(short_of.status, 0);
  EXPECT_EQ(short_of.json()["samples_per_replica"], 128);
}

/// The target is then one of the surface samples, and that of the pixels is no reason to warn.
TEST(Reference, PixelsOfFewerPathsAreToldApart) {
  const Workshop shop;
  const Outcome made = shop.gibench({"reference", "room.scene.json", "--surface-samples", "64", "--pixel-samples", "1",
                                     "--picture-samples", "4", "--target-error", "0.05"});
  ASSERT_EQ(made.status, 0) << made.error;
  EXPECT_THAT(made.out, testing::ContainsRegex("error 0\\.0[0-9]+ at the surface samples, [0-9.]+ of the pixels with 4 paths"));
  EXPECT_EQ(made.error, "");
}

TEST(Reference, ShardsMergeToTheSameReplicates) {
  const Workshop shop;
  const auto whole = shop.gibench(reference_of("room.scene.json", {"--samples", "32", "--references", "whole"})).json();
  const auto first =
      shop.gibench(reference_of("room.scene.json", {"--samples", "32", "--references", "parts", "--shard", "0/3"}));
  EXPECT_EQ(first.status, 0) << first.error;
  EXPECT_FALSE(first.json()["complete"].get<bool>());
  shop.gibench(reference_of("room.scene.json", {"--samples", "32", "--references", "parts", "--shard", "2/3"}));
  auto merged =
      shop.gibench(reference_of("room.scene.json", {"--samples", "32", "--references", "parts", "--shard", "1/3"})).json();
  merged["seconds"] = whole["seconds"];
  EXPECT_EQ(merged, whole);
}

TEST(Reference, BouncesMakeAnotherReference) {
  const Workshop shop;
  const auto all = shop.gibench(reference_of("room.scene.json", {"--samples", "16"})).json();
  const auto one = shop.gibench(reference_of("room.scene.json", {"--samples", "16", "--bounces", "1"})).json();
  EXPECT_NE(one["key"], all["key"]);
  EXPECT_EQ(one["path_class"], "C.{0,2}[LOB]");
}

TEST(Reference, IsWrittenAsPicturesWhereAskedFor) {
  const Workshop shop;
  ASSERT_EQ(shop.gibench(reference_of("room.scene.json", {"--samples", "16", "--out", "shown"})).status, 0);
  EXPECT_TRUE(shop.has("shown/reference.exr"));
  EXPECT_EQ(shop.read_json("shown/reference.json")["scene"], "room");
  EXPECT_EQ(shop.read_json("shown/reference.json")["resolution"], (std::vector<int>{8, 8}));
}

TEST(Reference, InterruptedItSaysWhatIsKept) {
  const Workshop shop;
  const Outcome outcome =
      shop.gibench(reference_of("room.scene.json", {"--samples", "1000000"}),
                   "(while ! ls references/*/meta.json >/dev/null 2>&1; do sleep 0.05; done; kill -INT $$) &");
  EXPECT_EQ(outcome.status, 4);
  EXPECT_THAT(outcome.error, testing::MatchesRegex("gibench: cancelled; the [0-9]+ paths per value and replicate made so far are "
                                                   "kept in references/[0-9a-f]+; the same command does the rest\n"));
}

TEST(Reference, WrongCallsAreTold) {
  const Workshop shop;
  expect_bad_input(shop.gibench(reference_of("room.scene.json", {"--shard", "3/3"})), {"--shard", "3/3", "0 <= i < n"});
  expect_bad_input(shop.gibench(reference_of("room.scene.json", {"--shard", "0/9"})), {"--shard"});
  expect_bad_input(shop.gibench(reference_of("room.scene.json", {"--shard", "0/2", "--target-error", "0.1"})),
                   {"--target-error", "--samples"});
  ASSERT_EQ(shop.gibench(reference_of("room.scene.json", {"--samples", "16"})).status, 0);
  expect_bad_input(shop.gibench(reference_of("room.scene.json", {"--samples", "32", "--replicas", "4"})), {"--replicas", "8"});
  shop.write("file", std::string("x"));
  expect_bad_input(shop.gibench(reference_of("room.scene.json", {"--references", "file/store"})), {"file", "cannot be"});
}

TEST(Reference, ADamagedOneIsTold) {
  const Workshop shop;
  const auto made = shop.gibench(reference_of("room.scene.json", {"--samples", "16"})).json();
  const std::filesystem::path folder = shop / "references" / made["key"].get<std::string>();
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().filename() != "meta.json") std::filesystem::resize_file(entry.path(), entry.file_size() / 2);
  expect_bad_input(
      shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--surface-samples", "64", "--pixel-samples", "1"}),
      {"damaged", "gibench reference"});
}

}  // namespace
}  // namespace gibench::test
