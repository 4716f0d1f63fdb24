// Lines, words and numbers of text files as people and programs write them.
#include "common/scene_io/text/text_lines.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gibench::test {
namespace {

using testing::ElementsAre;

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (TextLines walk(text); walk.next();) lines.push_back(std::to_string(walk.number()) + " " + std::string(walk.line()));
  return lines;
}

TEST(TextLines, EndsOfEverySystem) {
  EXPECT_THAT(lines_of("a\nb\n"), ElementsAre("1 a", "2 b"));
  EXPECT_THAT(lines_of("a\r\n\r\nb"), ElementsAre("1 a", "3 b"));
  EXPECT_THAT(lines_of("a\rb\r"), ElementsAre("1 a", "2 b"));
  EXPECT_THAT(lines_of(""), ElementsAre());
}

TEST(TextLines, BlanksAroundAreNoPartOfThem) { EXPECT_THAT(lines_of(" \t a  b\t\n   \n"), ElementsAre("1 a  b")); }

TEST(TextLines, BackslashContinuesALine) {
  EXPECT_THAT(lines_of("v 1 \\\n2 \\\r\n3\nw"), ElementsAre("1 v 1  2  3", "4 w"));
  EXPECT_THAT(lines_of("v 1 2\\"), ElementsAre("1 v 1 2"));
}

TEST(TextLines, CommentsEndWithTheirLine) {
  EXPECT_THAT(lines_of("# from C:\\work\\\nv 1\n  # x\nw # 1\n"), ElementsAre("2 v 1", "4 w # 1"));
}

TEST(TextLines, UnendedIsTheLastLineWithoutAnEnd) {
  TextLines walk("a\nb");
  ASSERT_TRUE(walk.next());
  EXPECT_FALSE(walk.is_unended());
  ASSERT_TRUE(walk.next());
  EXPECT_TRUE(walk.is_unended());
}

TEST(TextLines, WordsAndNumbers) {
  std::string_view line = "f  1/2\t-3";
  EXPECT_EQ(take_word(line), "f");
  EXPECT_EQ(take_word(line), "1/2");
  EXPECT_EQ(take_word(line), "-3");
  EXPECT_EQ(take_word(line), "");
  for (const auto& [word, value] :
       {std::pair(".5", 0.5), {"-.25", -0.25}, {"+3.", 3.0}, {"1e-3", 1e-3}, {"2E+2", 200.0}, {"1e-999", 0.0}})
    EXPECT_EQ(to_number(word), value) << word;
  EXPECT_EQ(to_number("-1e999"), -std::numeric_limits<double>::infinity());
  EXPECT_TRUE(std::isnan(to_number("nan").value()));
  for (const char* word : {"", "x", "0,5", "1.#QNAN", "1 2", "--1", "0x10"}) EXPECT_FALSE(to_number(word)) << word;
}

}  // namespace
}  // namespace gibench::test
