// STL files: text in any spelling, binary ones that look like text, and files that are cut short.
#include <cmath>
#include <cstring>

#include "tests/common/scene_io/model_text.h"

namespace gibench::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string facets =
    "  facet normal 0 0 1\n    outer loop\n      vertex -1 -1 0\n      vertex 1 -1 0\n      vertex 1 1 0\n    endloop\n  "
    "endfacet\n"
    "  facet normal 0 0 1\n    outer loop\n      vertex -1 -1 0\n      vertex 1 1 0\n      vertex -1 1 0\n    endloop\n  "
    "endfacet\n";

std::string upper_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return text;
}

std::string binary(const std::string& head, std::uint32_t announced, int written) {
  std::string data = head;
  data.resize(80, ' ');
  const auto put = [&data](auto value) { data.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(announced);
  for (int f = 0; f < written; ++f) {
    for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 2.F, 0.F}) put(x);
    put(std::uint16_t{0});
  }
  return data;
}

class StlTest : public ModelTextTest {
 protected:
  StlTest() : ModelTextTest("stl") {}
};

TEST_F(StlTest, TextOfEverySpelling) {
  std::string on_one_line = facets;
  for (char& c : on_one_line)
    if (c == '\n') c = ' ';
  for (const std::string& text : {"solid a\n" + facets + "endsolid a\n", "SOLID PART\n" + upper_case(facets) + "ENDSOLID PART\n",
                                  "\n  solid a\n" + facets + "endsolid a\n", "\xEF\xBB\xBFsolid a\r\n" + facets + "endsolid\r\n",
                                  "solid\n" + on_one_line + "\nendsolid\n"}) {
    const Scene scene = load_model(text);
    EXPECT_EQ(scene.faces.size(), 2U) << text;
    EXPECT_EQ(scene.vertices.size(), 4U) << text;  // joined
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no material")));
  }
}

TEST_F(StlTest, EachSolidIsAnObject) {
  const Scene scene =
      load_model("solid left one\n" + facets + "endsolid\nsolid right\n" + facets + "endsolid\nsolid none\nendsolid\n");
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].name, "left one");
  EXPECT_EQ(scene.objects[1].name, "right");
}

TEST_F(StlTest, BinaryThatBeginsAsText) {
  EXPECT_EQ(load_model(binary("solid made by a program", 2, 2)).faces.size(), 2U);
  EXPECT_THAT(load_model(binary("made", 1, 2)).warnings, Contains(HasSubstr("50 bytes after the last facet")));
  EXPECT_THAT(load_model(binary("COLOR=abcd", 1, 1)).warnings, Contains(HasSubstr("the colours of its facets are left out")));
}

TEST_F(StlTest, CutShort) {
  EXPECT_THAT(error(binary("", 3, 2)), HasSubstr("is cut short: it announces 3 facets, and 2 follow"));
  EXPECT_THAT(error(binary("", 0xFFFFFFFF, 1)), HasSubstr("is cut short"));
  EXPECT_THAT(error("solid a\n" + facets.substr(0, 60)), HasSubstr("is cut short"));
  EXPECT_THAT(error("short"), HasSubstr("is no STL"));
  EXPECT_THAT(load_model("solid a\n" + facets).warnings, Contains(HasSubstr("without \"endsolid\"")));
}

TEST_F(StlTest, WrongLinesAreNamed) {
  EXPECT_THAT(error("solid a\nfacet\nvertex 0 0 x\n"), HasSubstr("line 3: \"x\" is not a number"));
  EXPECT_THAT(error("solid a\nvertex 0 0 0\n"), HasSubstr("line 2: a vertex outside a facet"));
  EXPECT_THAT(error("solid a\nhello\n"), HasSubstr("line 2: \"hello\" is not understood"));
  EXPECT_THAT(error("solid a\nendsolid a\n"), HasSubstr("has no faces"));
}

}  // namespace
}  // namespace gibench::test
