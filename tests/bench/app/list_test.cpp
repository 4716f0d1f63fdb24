#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;

TEST(List, MethodsStandOneALine) {
  const Outcome outcome = Workshop().gibench({"list", "methods"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("pathtracer\n"));
  EXPECT_THAT(outcome.out, HasSubstr("meshless\n"));
  EXPECT_THAT(outcome.out, testing::Not(HasSubstr(" ")));
}

TEST(List, MethodsAsJsonCarryTheirParameters) {
  const auto methods = Workshop().gibench({"list", "methods", "--json"}).json();
  ASSERT_TRUE(methods.is_array());
  for (const auto& method : methods) {
    EXPECT_TRUE(method["summary"].is_string());
    EXPECT_TRUE(method["light_paths"].is_string());
    ASSERT_TRUE(method["parameters"].is_array());
    for (const auto& parameter : method["parameters"]) {
      EXPECT_TRUE(parameter.contains("default"));
      EXPECT_FALSE(parameter["meaning"].get<std::string>().empty());
    }
  }
}

TEST(List, OneMethodShowsItsParametersWithRangesAndDefaults) {
  const Outcome outcome = Workshop().gibench({"list", "methods", "pathtracer"});
  EXPECT_EQ(outcome.status, 0);
  EXPECT_THAT(outcome.out, HasSubstr("samples"));
  EXPECT_THAT(outcome.out, HasSubstr("default"));
}

TEST(List, AMethodShowsItsPresets) {
  const Workshop shop;
  const Outcome outcome = shop.gibench({"list", "methods", "meshless"});
  EXPECT_THAT(outcome.out,
              testing::AllOf(HasSubstr("presets (--preset NAME)"), HasSubstr("  paper "), HasSubstr("noise_guard=0")));
  const auto json = shop.gibench({"list", "methods", "meshless", "--json"}).json();
  ASSERT_FALSE(json["presets"].empty());
  EXPECT_EQ(json["presets"][0]["name"], "paper");
  EXPECT_EQ(json["presets"][0]["parameters"]["noise_guard"], "0");
}

TEST(List, EffectsMetricsAndScenes) {
  const Workshop shop;
  EXPECT_THAT(shop.gibench({"list", "effects"}).out, HasSubstr("diffuse_indirect\n"));
  EXPECT_THAT(shop.gibench({"list", "metrics"}).out, HasSubstr("rel_mse(0.01)\n"));
  EXPECT_THAT(shop.gibench({"list", "scenes"}).out, HasSubstr("cornell-box\n"));
  EXPECT_TRUE(shop.gibench({"list", "scenes", "--json"}).json().is_array());
}

TEST(List, WhatIsUnknownIsToldWithTheKnown) {
  const Workshop shop;
  expect_bad_input(shop.gibench({"list", "methods", "pathtracker"}), {"pathtracker", "known:", "pathtracer"});
  expect_bad_input(shop.gibench({"list", "colours"}), {"colours", "--help"});
}

TEST(Call, WrongCallsExitWithTwoAndOneLine) {
  const Workshop shop;
  expect_bad_input(shop.gibench({}), {"--help"});
  expect_bad_input(shop.gibench({"paint"}), {"paint"});
  expect_bad_input(shop.gibench({"run"}), {"gibench run --help"});
  expect_bad_input(shop.gibench({"run", "room.scene.json"}), {"--method"});
  expect_bad_input(shop.gibench({"list", "--threads", "many"}), {"--threads"});
  expect_bad_input(shop.gibench({"list", "--threads", "-1"}), {"--threads"});
  expect_bad_input(shop.gibench({"list", "--colour"}), {"--colour"});
}

TEST(Call, HelpNamesTheVerbsThatExistAndNoOthers) {
  const Outcome help = Workshop().gibench({"--help"});
  EXPECT_EQ(help.status, 0);
  for (const char* verb : {"list", "check", "run", "query", "reference", "compare", "relight", "study", "report"})
    EXPECT_THAT(help.out, HasSubstr(verb));
  for (const char* verb : {"edit", "selftest", "gate"}) EXPECT_THAT(help.out, testing::Not(HasSubstr(verb)));
}

TEST(Call, AFullDiskUnderStdoutIsAFailure) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "no /dev/full here";
  const Workshop shop;
  const std::string command = "\"" GIBENCH_PROGRAM "\" list methods --json >/dev/full 2>/dev/null";
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 4);
}

}  // namespace
}  // namespace gibench::test
