#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::HasSubstr;
using Json = nlohmann::ordered_json;

std::vector<std::string> verbs_of(const Json& tree) {
  std::vector<std::string> verbs;
  for (const Json& verb : tree["verbs"]) verbs.push_back(verb["name"]);
  return verbs;
}

/// The options, with their dashes, that stand at the beginning of the lines of a verb's --help.
std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> options;
  std::istringstream lines(help);
  const std::regex entry("^  (-[A-Za-z],)?(--[a-z-]+)");
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, found, entry)) options.insert(found[2].str());
  return options;
}

/// As troff writes it.
std::string in_bold(std::string text) { return "\\fB" + std::regex_replace(text, std::regex("-"), "\\-") + "\\fR"; }

TEST(Help, IsAnOverviewInGroups) {
  const Workshop shop;
  const Outcome help = shop.gibench({"help"});
  EXPECT_EQ(help.status, 0) << help.error;
  const Json tree = shop.gibench({"help", "--json"}).json();
  for (const Json& verb : tree["verbs"]) {
    EXPECT_THAT(help.out, HasSubstr("\n" + verb["group"].get<std::string>() + "\n"));
    EXPECT_THAT(help.out, testing::ContainsRegex("\n  " + verb["name"].get<std::string>() + " +[A-Z]"));
    EXPECT_FALSE(verb["read_on"].empty()) << verb["name"];
  }
  EXPECT_THAT(help.out, HasSubstr("--seed N --threads N --quiet --json"));
}

TEST(Help, ReadOnNamesPagesThatExist) {
  const Json tree = Workshop().gibench({"help", "--json"}).json();
  for (const Json& verb : tree["verbs"])
    for (const Json& page : verb["read_on"])
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(GIBENCH_SOURCE_DIR) / page.get<std::string>())) << page;
}

TEST(Help, OfAVerbIsWhatTheVerbSaysItself) {
  const Workshop shop;
  for (const std::string& verb : verbs_of(shop.gibench({"help", "--json"}).json())) {
    const Outcome help = shop.gibench({"help", verb});
    EXPECT_EQ(help.status, 0);
    EXPECT_EQ(help.out, shop.gibench({verb, "--help"}).out);
    EXPECT_THAT(help.out, HasSubstr("gibench " + verb));
  }
}

TEST(Help, AnUnknownVerbIsToldWithTheNearest) {
  const Workshop shop;
  expect_bad_input(shop.gibench({"help", "qurey"}), {"'qurey'", "did you mean \"query\"?", "verbs: list"});
  expect_bad_input(shop.gibench({"help", "run", "--man"}), {"--man"});
  expect_bad_input(shop.gibench({"qurey"}), {"'qurey'", "did you mean \"query\"?"});
  expect_bad_input(shop.gibench({"help", "run", "query"}), {"query", "gibench help --help"});
}

TEST(Help, AnUnknownOptionIsToldWithTheNearest) {
  const Workshop shop;
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--bouces", "2"}),
                   {"--bouces", "did you mean \"--bounces\"?", "gibench run --help"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "meshles"}), {"did you mean \"meshless\"?"});
  expect_bad_input(shop.gibench({"run", "room.scene.json", "--method", "pathtracer", "--set", "smaples=2"}),
                   {"did you mean \"samples\"?"});
  expect_bad_input(shop.gibench({"check", "room.scene.json", "--effects", "colur"}), {"did you mean \"colour\"?"});
  expect_bad_input(shop.gibench({"check", "cornel-box"}), {"did you mean \"cornell-box\"?"});
  expect_bad_input(shop.gibench({"list", "methods", "spectal"}), {"did you mean \"spectral\"?"});
}

TEST(ManualPage, HasEveryVerbAndOptionThatTheHelpHas) {
  const Workshop shop;
  const std::string page = shop.gibench({"help", "--man"}).out;
  EXPECT_THAT(page, testing::StartsWith(".TH GIBENCH 1 "));
  EXPECT_TRUE(std::all_of(page.begin(), page.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80U; }));
  std::size_t options = 0;
  for (const std::string& verb : verbs_of(shop.gibench({"help", "--json"}).json())) {
    EXPECT_THAT(page, HasSubstr(".SS \\fBgibench " + verb + "\\fR"));
    for (const std::string& option : options_in(shop.gibench({verb, "--help"}).out)) {
      EXPECT_THAT(page, HasSubstr(in_bold(option))) << verb;
      ++options;
    }
  }
  EXPECT_GT(options, 50U) << "the options in the help were not found";
}

TEST(ManualPage, NamesTheVariablesThatTheProgramReads) {
  const std::string page = Workshop().gibench({"help", "--man"}).out;
  for (const char* variable : {"GIBENCH_PATH", "GIBENCH_DATA", "GIBENCH_REPORTS", "GIBENCH_CHROMIUM"})
    EXPECT_THAT(page, HasSubstr(std::string(".B ") + variable + "\n"));
}

TEST(ManualPage, IsRenderedWithoutWarnings) {
  if (!is_installed("man") || !is_installed("groff")) GTEST_SKIP() << "no man or groff here";
  const Workshop shop;
  shop.write("gibench.1", shop.gibench({"help", "--man"}).out);
  const std::string command =
      "cd '" + shop.path().string() + "' && LC_ALL=C.UTF-8 MANWIDTH=80 man --warnings -l gibench.1 >page.txt 2>warnings.txt";
  EXPECT_EQ(std::system(command.c_str()), 0);
  EXPECT_EQ(shop.read("warnings.txt"), "");
  EXPECT_THAT(shop.read("page.txt"), HasSubstr("gibench run"));
}

}  // namespace
}  // namespace gibench::test
