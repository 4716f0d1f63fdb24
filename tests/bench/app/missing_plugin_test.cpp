#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;

/// The program alone, without the image plugin beside it. One line on stderr: a run that had done its work before it missed
/// the plugin would have warned of the reference that it did not find.
Outcome without_plugin(const Workshop& shop, const std::string& arguments) {
  return shop.gibench({}, "mkdir -p bin; cp '" GIBENCH_PROGRAM "' bin/; exec bin/gibench " + arguments +
                              " --surface-samples 64 --pixel-samples 1 --out out >stdout.txt 2>stderr.txt;");
}

TEST(MissingPlugin, IsFoundBeforeARun) {
  const Workshop shop;
  const Outcome outcome = without_plugin(shop, "run room.scene.json --method pathtracer --set samples=1");
  expect_bad_input(outcome, {"gibench_image_plugin.so", "the image plugin is missing"});
  EXPECT_FALSE(shop.has("out"));
  EXPECT_FALSE(shop.has("out.partial"));
}

TEST(MissingPlugin, IsFoundBeforeAReference) {
  const Workshop shop;
  const Outcome outcome = without_plugin(shop, "reference room.scene.json --samples 16");
  expect_bad_input(outcome, {"gibench_image_plugin.so", "the image plugin is missing"});
  EXPECT_FALSE(shop.has("references")) << "nothing was made";
}

TEST(MissingPlugin, IsNotMissedByARunWithoutPictures) {
  const Workshop shop;
  const Outcome outcome = without_plugin(shop, "run room.scene.json --method pathtracer --set samples=1 --no-pictures");
  EXPECT_EQ(outcome.status, 0) << outcome.error;
}

}  // namespace
}  // namespace gibench::test
