// OBJ files as programs write them: lines, colours, indices, names, what is left out.
#include <cmath>

#include "tests/common/scene_io/model_text.h"

namespace gibench::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string square = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\n";

class ObjTest : public ModelTextTest {
 protected:
  ObjTest() : ModelTextTest("obj") {}
};

TEST_F(ObjTest, ContinuedLinesFarFromTheOrigin) {
  const Scene scene = load_model("v 999999 -1 0\nv 1000001 -1 \\\n0\nv 1000001 1 0\nv 999999 1 0\nf 1 2 \\\r\n3 4\n");
  EXPECT_NEAR(area_of(scene), 4.0, 1e-6);
  EXPECT_EQ(scene.origin, Vec3d(1e6, 0, 0));
}

TEST_F(ObjTest, CommentsThatEndInABackslash) {
  EXPECT_NEAR(area_of(load_model("# exported from C:\\work\\\n" + square + "f 1 2 3 4\n")), 4.0, 1e-6);
  EXPECT_NEAR(area_of(load_model("v 9 9 9\n# head\\\n" + square + "f -4 -3 -2 -1 # the last four\n")), 4.0, 1e-6);
}

TEST_F(ObjTest, ByteOrderMarks) {
  write_text(folder_ / "m.mtl", "\xEF\xBB\xBFnewmtl a\nKd 0.5 0.25 0.125\nKs 0 0 0\n");
  const Scene scene = load_model("\xEF\xBB\xBFmtllib m.mtl\n" + square + "usemtl a\nf 1 2 3 4\n");
  EXPECT_EQ(scene.materials.at(0).diffuse, Rgb(0.5F, 0.25F, 0.125F));
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_NEAR(area_of(load_model("\xEF\xBB\xBF" + square + "f 1 2 3 4\n")), 4.0, 1e-6);
  EXPECT_THAT(error("\xFF\xFEv\0 \0"), HasSubstr("UTF-16"));
}

TEST_F(ObjTest, NumbersOfEverySpelling) {
  const Scene scene = load_model("v -.5 -5E-1 +0\nv .5 -0.50 0.\nv .5 .5 0e0\nv -.5 +.5 0\nf 1 2 3 4\n");
  EXPECT_NEAR(area_of(scene), 1.0, 1e-6);
}

TEST_F(ObjTest, DoublePrecisionStays) {
  const Scene scene = load_model("v 16777216.25 0 0\nv 16777217.25 0 0\nv 16777217.25 1 0\nf 1 2 3\nv 0 0 0\n");
  EXPECT_NEAR(area_of(scene), 0.5, 1e-7);
}

TEST_F(ObjTest, MeanColourOfTheVerticesIsTheAlbedo) {
  // Red on an area of 3, blue on an area of 1, where the two meet at vertices of both colours.
  const Scene scene = load_model(
      "v 0 0 0 1 0 0\nv 3 0 0 1 0 0\nv 3 1 0 1 0 0\nv 0 1 0 1 0 0\nf 1 2 3 4\n"
      "v 3 0 0 0 0 .5\nv 4 0 0 0 0 .5\nv 4 1 0 0 0 .5\nv 3 1 0 0 0 .5\nf 5 6 7 8\n");
  EXPECT_EQ(scene.material_of_object(0).diffuse, Rgb(0.75F, 0.0F, 0.125F));
  const Scene plain = load_model(
      "v -1 -1 0 0.5 0.25 0.125\nv 1 -1 0 0.5 0.25 0.125\nv 1 1 0 0.5 0.25 0.125\nv -1 1 0 0.5 0.25 0.125\nf 1 2 3 4\n");
  EXPECT_EQ(plain.material_of_object(0).diffuse, Rgb(0.5F, 0.25F, 0.125F));
  EXPECT_THAT(plain.warnings, ElementsAre(HasSubstr("the mean colour of the vertices is the albedo")));
}

TEST_F(ObjTest, EachObjectHasTheColourOfItsOwnVertices) {
  const Scene scene = load_model(
      "o a\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nf 1 2 3\n"
      "o b\nv 2 0 0 0 1 0\nv 5 0 0 0 1 0\nv 5 1 0 0 1 0\nf 4 5 6\n");
  EXPECT_EQ(scene.material_of_object(0).diffuse, Rgb(1, 0, 0));
  EXPECT_EQ(scene.material_of_object(1).diffuse, Rgb(0, 1, 0));
}

TEST_F(ObjTest, ColoursBesideAMaterialAreNamed) {
  write_text(folder_ / "m.mtl", "newmtl a\nKd 0.5 0.5 0.5\n");
  const Scene scene = load_model("mtllib m.mtl\nusemtl a\nv 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nf 1 2 3\n");
  EXPECT_EQ(scene.material_of_object(0).diffuse, Rgb(0.5F));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("colours of vertices that have a material are left out")));
  const Scene partial = load_model("v 0 0 0 1 0 0\nv 1 0 0\nv 1 1 0 1 0 0\nf 1 2 3\n");
  EXPECT_THAT(partial.warnings, Contains(HasSubstr("some vertices have a colour")));
}

TEST_F(ObjTest, NamesThatAreDefinedNowhere) {
  const Scene without = load_model(square + "usemtl steel\nf 1 2 3 4\n");
  EXPECT_THAT(without.warnings, ElementsAre(HasSubstr("materials that are defined nowhere: \"steel\"; diffuse with albedo 0.6")));
  EXPECT_EQ(without.materials.at(0).name, "steel");
  write_text(folder_ / "other.mtl", "newmtl wood\nKd 0.5 0.5 0.5\n");
  const Scene wrong = load_model("mtllib other.mtl\n" + square + "usemtl wood\nf 1 2 3\nusemtl stone\nf 1 3 4\n");
  EXPECT_THAT(wrong.warnings, ElementsAre(HasSubstr("defined nowhere: \"stone\"")));
}

TEST_F(ObjTest, MaterialFilesWithBlanksSeveralAndOfTheSameName) {
  write_text(folder_ / "my paint.mtl", "newmtl a\nKd 1 0 0\n");
  write_text(folder_ / "two.mtl", "newmtl b\nKd 0 1 0\n");
  const std::string faces = square + "usemtl a\nf 1 2 3\nusemtl b\nf 1 3 4\n";
  const Scene scene = load_model("mtllib my paint.mtl\nmtllib two.mtl\n" + faces);
  EXPECT_EQ(scene.material_of_object(0).diffuse, Rgb(1, 0, 0));
  EXPECT_EQ(scene.material_of_object(1).diffuse, Rgb(0, 1, 0));
  write_text(folder_ / "m.mtl", "newmtl a\nKd 0 0 1\nnewmtl b\nKd 0 0 1\n");
  const Scene fallback = load_model("mtllib old-name.mtl\n" + faces);
  EXPECT_EQ(fallback.material_of_object(0).diffuse, Rgb(0, 0, 1));
  EXPECT_THAT(fallback.warnings, ElementsAre(HasSubstr("\"old-name.mtl\" does not exist, \"m.mtl\" is read")));
}

TEST_F(ObjTest, GroupsAndObjectsNameTheParts) {
  const Scene scene = load_model(square + "f 1 2 3\no wall\nf 1 2 3\ng wall left\nf 1 3 4\no wall\nf 2 3 4\n");
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  EXPECT_THAT(names, ElementsAre("m", "wall", "wall left"));
  EXPECT_EQ(scene.objects[1].face_end - scene.objects[1].face_begin, 2U);
}

TEST_F(ObjTest, UnknownStatementsAreNamedOnce) {
  const Scene scene = load_model(square + "vn 0 0 1\ns off\nvp 1\nmg 0\nsurf 0 1\nsurf 0 1\nhello\nf 1 2 3 4\np 1\n");
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("unknown statements are left out: \"hello\", \"surf\"")));
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("1 points and lines")));
  EXPECT_THAT(load_model("v 0 0 0 2\nv 1 0 0 1\nv 1 1 0\nf 1 2 3\n").warnings, Contains(HasSubstr("weights of vertices")));
}

TEST_F(ObjTest, FacesMayStandBeforeTheirVertices) {
  EXPECT_NEAR(area_of(load_model("f 1 2 3 4\n" + square)), 4.0, 1e-6);
  EXPECT_THAT(error("f 1 2 5\n" + square), HasSubstr("line 1: the index 5 is out of range: there are 4 vertices"));
  EXPECT_THAT(error("f 1 1 1\n"), HasSubstr("out of range"));
}

TEST_F(ObjTest, WrongLinesAreNamed) {
  EXPECT_THAT(error("v 0 0 x\n" + square), HasSubstr("line 1: \"x\" is not a number"));
  EXPECT_THAT(error(square + "v 1 2\nf 1 2 3\n"), HasSubstr("line 5: a vertex of 2 numbers"));
  EXPECT_THAT(error(square + "f 1 2 0\n"), HasSubstr("line 5: the index in \"0\" is out of range"));
  EXPECT_THAT(error(square + "f -5 2 3\n"), HasSubstr("line 5: the index in \"-5\" is out of range"));
  EXPECT_THAT(error(square + "f 1 2 a\n"), HasSubstr("line 5: \"a\" is not a corner"));
  EXPECT_THAT(error(square + "f 1/1 2/1 3/1\n"), HasSubstr("there are 0 texture points"));
  EXPECT_THAT(error(square + "f 1 2 x\n"), Not(HasSubstr("cut short")));
}

TEST_F(ObjTest, NamesInOtherEncodingsArePrintable) {
  const Scene scene = load_model("o gr\xFC\xDF\nusemtl \033[31m\n" + square + "f 1 2 3 4\n");
  EXPECT_EQ(scene.objects.at(0).name, "gr\\xfc\\xdf/\\x1b[31m");
  EXPECT_THAT(scene.warnings, Contains(HasSubstr("\\x1b[31m")));
}

}  // namespace
}  // namespace gibench::test
