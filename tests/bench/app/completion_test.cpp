#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>

#include "tests/bench/app/program.h"

namespace gibench::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsSupersetOf;
using testing::Not;
using Words = std::vector<std::string>;

Words lines_of(const std::string& text) {
  Words lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// What the program offers next, without meanings.
Words offered(const Workshop& shop, const Words& typed) {
  Words arguments{"completion", "words", "--"};
  arguments.insert(arguments.end(), typed.begin(), typed.end());
  const Outcome outcome = shop.gibench(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.error;
  Words words = lines_of(outcome.out);
  for (std::string& word : words) word = word.substr(0, word.find('\t'));
  return words;
}

TEST(Completion, OffersVerbsOptionsAndNames) {
  const Workshop shop;
  EXPECT_THAT(offered(shop, {""}), IsSupersetOf({"list", "run", "study", "help", "completion"}));
  EXPECT_THAT(offered(shop, {"re"}), ElementsAre("reference", "relight", "report"));
  EXPECT_THAT(offered(shop, {"--"}), ElementsAre("--help", "--version"));
  EXPECT_THAT(offered(shop, {"run", "cornell-b"}), ElementsAre("cornell-box", ":files"));
  EXPECT_THAT(offered(shop, {"run", "cornell-box", "--surface-s"}), ElementsAre("--surface-samples"));
  EXPECT_THAT(offered(shop, {"run", "cornell-box", ""}), Contains("--method"));
  EXPECT_THAT(offered(shop, {"run", "--quiet", "--q"}), ElementsAre()) << "given already";
  EXPECT_THAT(offered(shop, {"run", "room", "--set", "a=1", "--se"}), ElementsAre("--seed", "--set")) << "may be given again";
  EXPECT_THAT(offered(shop, {"run", "room", "--method", ""}),
              IsSupersetOf({"pathtracer", "meshless", "spectral", "antiradiance"}));
  EXPECT_THAT(offered(shop, {"run", "room", "--method=mesh"}), ElementsAre("--method=meshless"));
  EXPECT_THAT(offered(shop, {"study", "q"}), ElementsAre("quick", ":files"));
  EXPECT_THAT(offered(shop, {"run", "room", "--out", ""}), ElementsAre(":folders"));
  EXPECT_THAT(offered(shop, {"run", "room", "--reference", "n"}), ElementsAre("none", ":folders"));
  EXPECT_THAT(offered(shop, {"help", "rep"}), ElementsAre("report"));
  EXPECT_THAT(offered(shop, {"list", "m"}), ElementsAre("methods", "metrics"));
  EXPECT_THAT(offered(shop, {"list", "effects", "gl"}), ElementsAre("glossy_final_bounce", "glossy_chain"));
  EXPECT_THAT(offered(shop, {"list", "metrics", "hdr"}), ElementsAre("hdr_flip"));
  EXPECT_THAT(offered(shop, {"completion", ""}), ElementsAre("bash", "zsh", "fish", "words"));
  EXPECT_THAT(offered(shop, {"check", "room", "--effects", "direct,col"}), ElementsAre("direct,colour"));
  EXPECT_THAT(offered(shop, {"nosuch", ""}), ElementsAre());
  EXPECT_THAT(offered(shop, {"run", "room", "--seed", ""}), ElementsAre()) << "a number";
}

TEST(Completion, OffersTheParametersOfTheMethodThatIsNamed) {
  const Workshop shop;
  EXPECT_THAT(offered(shop, {"run", "room", "--method", "pathtracer", "--set", "samp"}), ElementsAre("samples="));
  EXPECT_THAT(offered(shop, {"run", "room", "--method=pathtracer", "--set=samp"}), ElementsAre("--set=samples="));
  EXPECT_THAT(offered(shop, {"run", "room", "--set", ""}), ElementsAre()) << "of no method";
  EXPECT_THAT(offered(shop, {"run", "room", "--method", "antiradiance", "--set", "mode=acc"}), ElementsAre("mode=accessibility"));
  EXPECT_THAT(offered(shop, {"run", "room", "--method", "pathtracer", "--set", "samples="}), Not(Contains("samples=")));
}

TEST(Completion, OffersThePresetsOfTheMethodThatIsNamed) {
  const Workshop shop;
  EXPECT_THAT(offered(shop, {"run", "room", "--method", "meshless", "--preset", ""}), ElementsAre("paper"));
  EXPECT_THAT(offered(shop, {"run", "room", "--preset", ""}), ElementsAre()) << "of no method";
}

TEST(Completion, EveryOptionOfEveryVerbIsOffered) {
  const Workshop shop;
  const auto tree = shop.gibench({"help", "--json"}).json();
  EXPECT_GT(tree["verbs"].size(), 10U);
  for (const auto& verb : tree["verbs"]) {
    const Words found = offered(shop, {verb["name"], "-"});
    for (const auto& option : verb["options"]) {
      const std::string name = option["names"].back();
      if (!name.starts_with("-")) continue;
      EXPECT_THAT(found, Contains(name)) << verb["name"];
    }
  }
}

TEST(Completion, AsJsonAndWrongCalls) {
  const Workshop shop;
  const auto json = shop.gibench({"completion", "words", "--json", "--", "run", "cornell-b"}).json();
  EXPECT_EQ(json["words"][0]["word"], "cornell-box");
  EXPECT_EQ(json["files"], true);
  EXPECT_THAT(shop.gibench({"completion", "bash", "--json"}).json()["script"], testing::HasSubstr("complete -F"));
  expect_bad_input(shop.gibench({"completion"}), {"what", "--help"});
  expect_bad_input(shop.gibench({"completion", "csh"}), {"csh", "bash"});
}

/// Runs a script of a shell that has the program in its PATH and gives its lines on stdout.
Words said_by(const Workshop& shop, const std::string& shell, const std::string& script) {
  shop.write("script", script);
  const std::string folder = std::filesystem::path(GIBENCH_PROGRAM).parent_path().string();
  const std::string command =
      "cd '" + shop.path().string() + "' && PATH='" + folder + "':\"$PATH\" " + shell + " script >said 2>complaints";
  EXPECT_EQ(std::system(command.c_str()), 0) << shop.read("complaints");
  return lines_of(shop.read("said"));
}

/// Bash splits the line at "=" as well, as its completion does; the last word is the one at the cursor.
Words bash_offers(const Workshop& shop, const std::string& words, const std::string& program = "gibench") {
  return said_by(
      shop, "bash",
      "source <(gibench completion bash)\ncomplete -p gibench >/dev/null || exit 1\ncompopt() { echo \"$@\" >>compopt; }\n"
      "COMP_WORDBREAKS=$' \\t\\n\"\\'><=;|&(:'\nCOMP_WORDS=(" +
          program + " " + words +
          ")\nCOMP_CWORD=$((${#COMP_WORDS[@]} - 1))\n_gibench\nfor word in \"${COMPREPLY[@]}\"; do echo \"$word\"; done\n");
}

TEST(CompletionInBash, VerbsOptionsAndScenes) {
  const Workshop shop;
  EXPECT_THAT(bash_offers(shop, "re"), ElementsAre("reference", "relight", "report"));
  EXPECT_THAT(bash_offers(shop, "run cornell-box --meth"), ElementsAre("--method", "--method-seeds"));
  EXPECT_THAT(bash_offers(shop, "run cornell-b"), ElementsAre("cornell-box"));
  EXPECT_THAT(bash_offers(shop, "run cornell-b", "'" GIBENCH_PROGRAM "'"), ElementsAre("cornell-box")) << "by its path";
}

TEST(CompletionInBash, BehindASignOnlyWhatIsNew) {
  const Workshop shop;
  EXPECT_THAT(bash_offers(shop, "run room --method pathtracer --set samp"), ElementsAre("samples="));
  EXPECT_THAT(shop.read("compopt"), testing::HasSubstr("-o nospace"));
  EXPECT_THAT(bash_offers(shop, "run room --method = mesh"), ElementsAre("meshless"));
  EXPECT_THAT(bash_offers(shop, "run room --method antiradiance --set mode = acc"), ElementsAre("accessibility"));
  EXPECT_THAT(bash_offers(shop, "run room --method antiradiance --set mode ="), Contains("accessibility"));
}

TEST(CompletionInBash, FilesAndFolders) {
  const Workshop shop;
  std::filesystem::create_directories(shop / "a folder");
  EXPECT_THAT(bash_offers(shop, "run furn"),
              testing::UnorderedElementsAre("furnace-cube", "furnace-irregular", "furnace.scene.json"));
  EXPECT_THAT(bash_offers(shop, "run room --out a"), ElementsAre("a folder"));
  EXPECT_THAT(bash_offers(shop, "run room --out = a"), ElementsAre("a folder"));
  EXPECT_THAT(shop.read("compopt"), testing::HasSubstr("-o filenames"));
}

TEST(CompletionInZsh, VerbsOptionsAndScenes) {
  if (!is_installed("zsh")) GTEST_SKIP() << "no zsh here";
  const Workshop shop;
  const auto offers = [&](const std::string& words) {
    return said_by(shop, "zsh -f",
                   "compdef() { [[ \"$*\" == '_gibench gibench' ]] || exit 1 }\n_describe() { print -rl -- \"${(@P)2}\" }\n"
                   "compset() { : }\n_files() { print -- \"files $*\" }\nsource <(gibench completion zsh)\nwords=(gibench " +
                       words + ")\nCURRENT=$#words\n_gibench\n");
  };
  EXPECT_THAT(offers("rel"), ElementsAre(testing::StartsWith("relight:Moves lights")));
  EXPECT_THAT(offers("run cornell-box --meth"), ElementsAre(testing::StartsWith("--method:")));
  EXPECT_THAT(offers("run cornell-b"), ElementsAre("cornell-box:", "files "));
  EXPECT_THAT(offers("run room --out ''"), ElementsAre("files -/"));
  EXPECT_THAT(offers("run room --method pathtracer --set samp"), ElementsAre(testing::StartsWith("samples=:paths")));
}

TEST(CompletionInFish, VerbsOptionsAndScenes) {
  if (!is_installed("fish")) GTEST_SKIP() << "no fish here";
  const Workshop shop;
  const auto offers = [&](const std::string& line) {
    return said_by(shop, "env HOME='" + shop.path().string() + "' fish",
                   "gibench completion fish | source\ncomplete -C '" + line + "'\n");
  };
  EXPECT_THAT(offers("gibench rel"), ElementsAre(testing::StartsWith("relight\tMoves lights")));
  EXPECT_THAT(offers("gibench run cornell-box --meth"), ElementsAre(testing::StartsWith("--method\t")));
  EXPECT_THAT(offers("gibench run cornell-b"), ElementsAre("cornell-box"));
  EXPECT_THAT(offers("gibench run room --method pathtracer --set samp"), ElementsAre(testing::StartsWith("samples=\tpaths")));
}

}  // namespace
}  // namespace gibench::test
