// PLY files: formats, headers as programs write them, colours, strips, and files that announce more than they hold.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "tests/common/scene_io/model_text.h"

namespace gibench::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

const std::string square = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3\n";

std::string header(const std::string& format, const std::string& line_end = "\n") {
  std::string text;
  for (const char* line : {"ply", "", "element vertex 4", "property float x", "property float y", "property float z",
                           "element face 1", "property list uchar int vertex_indices", "end_header"})
    text += (*line != '\0' ? line : "format " + format + " 1.0") + line_end;
  return text;
}

/// The square in binary, its first coordinate as close to 1 as makes its first byte `first`.
std::string binary_square(bool big_endian, char first = 0) {
  std::string data;
  const auto put = [&](const auto& value) {
    std::string bytes(sizeof value, '\0');
    std::memcpy(bytes.data(), &value, sizeof value);
    if (big_endian) std::reverse(bytes.begin(), bytes.end());
    data += bytes;
  };
  for (const float x : {1.F, -1.F, 0.F, 1.F, 1.F, 0.F, -1.F, 1.F, 0.F, -1.F, -1.F, 0.F}) put(x);
  put(static_cast<unsigned char>(4));
  for (const int i : {0, 1, 2, 3}) put(i);
  if (!big_endian) data[0] = first;
  return data;
}

class PlyTest : public ModelTextTest {
 protected:
  PlyTest() : ModelTextTest("ply") {}
};

TEST_F(PlyTest, FormatsAndLineEnds) {
  for (const char* end : {"\n", "\r\n", "\r"}) {
    std::string text = header("ascii") + square;
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += std::strlen(end)) text.replace(at, 1, end);
    EXPECT_NEAR(area_of(load_model(text)), 4.0, 1e-6);
    EXPECT_NEAR(area_of(load_model(header("binary_little_endian", end) + binary_square(false))), 4.0, 1e-6);
    EXPECT_NEAR(area_of(load_model(header("binary_big_endian", end) + binary_square(true))), 4.0, 1e-6);
  }
}

TEST_F(PlyTest, FirstByteOfTheDataMayBeAnyByte) {
  for (int byte = 0; byte < 256; ++byte)
    EXPECT_NEAR(area_of(load_model(header("binary_little_endian") + binary_square(false, static_cast<char>(byte)))), 4.0, 1e-4)
        << byte;
}

TEST_F(PlyTest, DoublePrecisionStays) {
  const Scene scene = load_model(
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\nelement face 1\n"
      "property list uchar int vertex_index\nend_header\n16777216.25 0 0\n16777217.25 0 0\n16777217.25 1 0\n3 0 1 2\n");
  EXPECT_NEAR(area_of(scene), 0.5, 1e-7);
}

TEST_F(PlyTest, MeanColourOfTheVerticesIsTheAlbedo) {
  const std::string faces = "element face 2\nproperty list uint8 int32 vertex_indices\nend_header\n";
  const std::string area_3_and_1 = "3 0 1 2\n3 3 4 5\n";
  const auto ply = [&](const std::string& type, const std::string& full, const std::string& half) {
    std::string text = "ply\nformat ascii 1.0\nelement vertex 6\nproperty " + type + " red\nproperty " + type +
                       " green\nproperty " + type + " blue\nproperty float x\nproperty float y\nproperty float z\n" + faces;
    for (const char* place : {"0 0 0", "3 0 0", "3 2 0"}) text += full + " 0 0 " + place + "\n";
    for (const char* place : {"4 0 0", "5 0 0", "5 2 0"}) text += "0 0 " + half + " " + place + "\n";
    return text + area_3_and_1;
  };
  const Scene scene = load_model(ply("uchar", "255", "51"));
  EXPECT_NEAR(scene.material_of_object(0).diffuse.r, 0.75F, 1e-6F);
  EXPECT_NEAR(scene.material_of_object(0).diffuse.b, 0.05F, 1e-6F);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the mean colour of the vertices is the albedo")));
  EXPECT_NEAR(load_model(ply("float", "1", "0.2")).material_of_object(0).diffuse.b, 0.05F, 1e-6F);
}

TEST_F(PlyTest, StripsAndPolygonsAndWhatIsLeftOut) {
  const Scene scene = load_model(
      "ply\nformat ascii 1.0\ncomment TextureFile wood.png\nobj_info x\nelement vertex 6\nproperty float x\nproperty float y\n"
      "property float z\nproperty float quality\nelement tristrips 1\nproperty list int int vertex_indices\nelement edge 1\n"
      "property int vertex1\nproperty int vertex2\nend_header\n0 0 0 9\n1 0 0 9\n0 1 0 9\n1 1 0 9\n0 2 0 9\n1 2 0 9\n"
      "7 0 1 2 3 -1 2 3\n0 1\n");
  ASSERT_EQ(scene.faces.size(), 2U);
  for (const Triangle& t : scene.triangles) {
    const Vec3 a = scene.vertices[t.corners[0]], b = scene.vertices[t.corners[1]], c = scene.vertices[t.corners[2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0.0F);  // all fronts up
  }
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("left out: \"edge\""), HasSubstr("its picture \"wood.png\" is not used"),
                                          HasSubstr("no material")));
}

TEST_F(PlyTest, CountsThatTheFileIsTooShortFor) {
  std::string many_vertices = header("ascii") + square;
  many_vertices.replace(many_vertices.find("vertex 4"), 8, "vertex 2000000000");
  EXPECT_THAT(error(many_vertices), HasSubstr("cut short: its header announces 2000000000 records of \"vertex\""));
  EXPECT_THAT(error(header("ascii") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n2000000000 0 1 2 3\n"),
              HasSubstr("has a list of 2000000000 numbers in \"face\" 0 of 1, and has no bytes"));
  std::string long_list = binary_square(false);
  long_list[48] = '\xFF';
  EXPECT_THAT(error(header("binary_little_endian") + long_list), HasSubstr("has a list of 255 numbers"));
  std::string empty_records = header("ascii") + square;
  empty_records.replace(empty_records.find("end_header"), 0, "element nothing 18446744073709551615\n");
  EXPECT_EQ(load_model(empty_records).faces.size(), 1U);
  EXPECT_THAT(error(header("binary_little_endian") + binary_square(false).substr(0, 48)),
              HasSubstr("it ends before \"face\" 0 of 1"));
}

TEST_F(PlyTest, HeadersThatAreNone) {
  std::string joined = header("binary_little_endian") + binary_square(false);
  joined[joined.find("end_header") - 1] = 'J';
  EXPECT_THAT(error(joined), HasSubstr("its header has no end_header"));
  for (const char* wrong : {"property list uchar int", "property list float int a", "property quad x", "element face",
                            "element face -1", "element face 1x", "format ascii_2 1.0", "hello"})
    EXPECT_THAT(error("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\n" + std::string(wrong) + "\nend_header\n1\n"),
                testing::AnyOf(HasSubstr("line 5"), HasSubstr("x, y and z")))
        << wrong;
  EXPECT_THAT(error("hello\n"), HasSubstr("is no PLY"));
  EXPECT_THAT(error("ply\nformat ascii 1.0\nend_header\n"), HasSubstr("has no faces"));
}

TEST_F(PlyTest, WrongLinesAreNamed) {
  EXPECT_THAT(error(header("ascii") + "0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"), HasSubstr("line 10: it has fewer numbers"));
  EXPECT_THAT(error(header("ascii") + "0 0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"), HasSubstr("line 10: it has more numbers"));
  EXPECT_THAT(error(header("ascii") + "0 0 x\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n"), HasSubstr("line 10: \"x\" is not a number"));
  EXPECT_THAT(error(header("ascii") + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 -3\n"), HasSubstr("has vertex index -3"));
  EXPECT_THAT(load_model(header("ascii") + square + "1 2 3\n").warnings,
              testing::Contains(HasSubstr("5 bytes after the last element")));
}

TEST_F(PlyTest, ASecondElementOfVerticesIsRefused) {
  std::string text = header("ascii");
  const std::string second = "element vertex 2\nproperty float x\nproperty float y\nproperty float z\n";
  text.insert(text.find("element face"), second);
  EXPECT_THAT(error(text + "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n5 5 5\n6 6 6\n4 0 1 2 3\n"), HasSubstr("two elements \"vertex\""));
}

TEST_F(PlyTest, ColoursOfFacesAreNamed) {
  std::string text = header("ascii");
  text.insert(text.find("end_header"), "property uchar red\nproperty uchar green\nproperty uchar blue\n");
  const Scene scene = load_model(text + "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n4 0 1 2 3 255 0 0\n");
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("the colours of its faces are left out")));
}

}  // namespace
}  // namespace gibench::test
