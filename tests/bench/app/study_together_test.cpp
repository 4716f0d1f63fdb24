/// Calls that work in one folder at the same time.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/app/small_study.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// Both calls, as a shell begins them together; their statuses and stderr in files one.* and two.*.
void together(const Workshop& shop, const std::string& one, const std::string& two) {
  const std::string program = "'" GIBENCH_PROGRAM "'";
  const auto call = [&](const std::string& arguments, const std::string& name) {
    return "(" + program + " " + arguments + " >/dev/null 2>" + name + ".err; echo $? >" + name + ".status) & ";
  };
  shop.gibench({"--version"}, call(one, "one") + call(two, "two") + "wait;");
}

TEST(Together, ShardsShareOneFolder) {
  const Workshop alone, shop;
  Json json = small_study({1, 2, 4});
  json["scenes"].push_back("furnace.scene.json");
  ASSERT_EQ(study(alone, json).status, 0);
  shop.write("small.study.json", json);
  together(shop, "study small.study.json --out out --shard 0/2", "study small.study.json --out out --shard 1/2");
  EXPECT_EQ(shop.read("one.status"), "0\n") << shop.read("one.err");
  EXPECT_EQ(shop.read("two.status"), "0\n") << shop.read("two.err");
  const Json answers = answers_in(alone, "out");
  ASSERT_EQ(answers.size(), 6U);
  EXPECT_EQ(answers_in(shop, "out"), answers);
  for (const auto& entry : std::filesystem::directory_iterator(shop / "out"))
    EXPECT_THAT(entry.path().filename(), testing::AnyOf("manifest.json", "runs", "references"));
}

TEST(Together, TwoRunsWithOneOutAreOneAndARefusal) {
  const Workshop shop;
  const auto run = [](const char* samples) {
    return std::string("'" GIBENCH_PROGRAM "' run room.scene.json --method pathtracer --set samples=") + samples +
           " --surface-samples 64 --pixel-samples 1 --reference none --out out --force";
  };
  // The first would work for hours: it is interrupted when the second, begun once the first one's folder is there, has ended.
  shop.gibench({"--version"},
               run("1000000000") +
                   " >/dev/null 2>one.err & first=$!; while [ ! -e out.partial ] && kill -0 $first; do sleep 0.01; done; " +
                   run("1") + " >/dev/null 2>two.err; echo $? >two.status; kill -INT $first; wait $first; echo $? >one.status; " +
                   run("1") + " >/dev/null 2>three.err; echo $? >three.status;");
  EXPECT_EQ(shop.read("two.status"), "2\n");
  EXPECT_THAT(shop.read("two.err"), HasSubstr("gibench: out: another gibench works in this folder; wait for it to end"));
  EXPECT_EQ(shop.read("one.status"), "4\n") << shop.read("one.err");
  EXPECT_EQ(shop.read("three.status"), "0\n") << shop.read("three.err");
  EXPECT_TRUE(shop.has("out/result.json"));
  EXPECT_FALSE(shop.has("out.lock"));
}

TEST(Together, TwoCallsForOneReferenceBothEndWell) {
  const Workshop shop;
  const std::string make =
      "reference room.scene.json --samples 256 --surface-samples 64 --pixel-samples 1 --references store --out out --force";
  together(shop, make, make);
  EXPECT_EQ(shop.read("one.status"), "0\n") << shop.read("one.err");
  EXPECT_EQ(shop.read("two.status"), "0\n") << shop.read("two.err");
  EXPECT_EQ(shop.read_json("out/reference.json")["samples_per_replica"], 256);
  EXPECT_TRUE(shop.has("out/reference.exr"));
  EXPECT_FALSE(shop.has("out.partial"));
}

}  // namespace
}  // namespace gibench::test
