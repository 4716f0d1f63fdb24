// MTL files as programs write them: what is honoured, and what a warning names.
#include <cmath>

#include "common/image/image_file.h"
#include "tests/common/scene_io/scene_text.h"
#include "tests/support/png_bytes.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class MtlTest : public testing::Test {
 protected:
  /// A square with a material of these lines; its texture points span `u` of the picture's width.
  Scene load_with(const std::string& lines, const std::string& u = "1") {
    write_text(folder_ / "m.mtl", "newmtl a\n" + lines);
    write_text(folder_ / "m.obj", "mtllib m.mtl\nv -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt " + u + " 0\nvt " + u +
                                      " 1\nvt 0 1\nusemtl a\nf 1/1 2/2 3/3 4/4\n");
    return load_scene(folder_ / "m.obj");
  }
  Material material(const std::string& lines) { return load_with(lines).materials.at(0); }
  ScratchFolder folder_;
};

const Rgb colour(0.5F, 0.25F, 0.125F);
const std::string kd = "Kd 0.5 0.25 0.125\n";

TEST_F(MtlTest, PrAndPmOfWhatIsNoMetal) {
  const Scene scene = load_with("Ns 250\nKa 1 1 1\n" + kd + "Ks 0 0 0\nKe 0 0 0\nNi 1.45\nd 1\nillum 2\nPr 1.0\nPm 0.0\n");
  EXPECT_EQ(scene.materials.at(0).bsdf, Bsdf::diffuse);
  EXPECT_EQ(scene.materials[0].diffuse, colour);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(MtlTest, PmIsAMetalOfItsColour) {
  const Material metal = material(kd + "Ks 1 1 1\nPm 1\nPr 0.25\n");
  EXPECT_EQ(metal.bsdf, Bsdf::ggx);
  EXPECT_EQ(metal.f0, colour);
  EXPECT_EQ(metal.diffuse, Rgb(0.0F));
  EXPECT_EQ(metal.roughness, 0.25F);
  // Without Pr as rough as Ns: n = 2/α² − 2 is 30 at α = 1/4, roughness 1/2.
  EXPECT_NEAR(material(kd + "Pm 1\nNs 30\n").roughness, 0.5F, 1e-6F);
}

TEST_F(MtlTest, PrWithoutNsIsTheHighlightsWidth) {
  const Material satin = material(kd + "Ks .25 .25 .25\nPr 0.5\n");
  EXPECT_EQ(satin.bsdf, Bsdf::phong);
  EXPECT_NEAR(satin.exponent, 30.0F, 1e-3F);
  const Scene both = load_with(kd + "Ks .25 .25 .25\nPr 0.5\nNs 7\n");
  EXPECT_EQ(both.materials.at(0).exponent, 7.0F);
  EXPECT_THAT(both.warnings, ElementsAre(HasSubstr("Pr is not used")));
}

TEST_F(MtlTest, AnisotropyAndSheenOfZeroAreNothing) {
  const Scene zero = load_with(kd + "Ks 0 0 0\nillum 2\naniso 0.0\nanisor 0.0\nPs 0\nPc 0.0\nPcr 0.0\n");
  EXPECT_EQ(zero.materials.at(0).diffuse, colour);
  EXPECT_THAT(zero.warnings, IsEmpty());
  EXPECT_THAT(load_with(kd + "aniso 0.5\nPc 1\n").warnings,
              ElementsAre(AllOf(HasSubstr("aniso is not simulated"), HasSubstr("Pc is not simulated"))));
}

TEST_F(MtlTest, OneNumberIsGrey) {
  EXPECT_EQ(material("Kd 0.5\n").diffuse, Rgb(0.5F));
  EXPECT_EQ(material("Kd .5 # grey\n").diffuse, Rgb(0.5F));
  EXPECT_EQ(material(kd + "Ke 2\n").emission, Rgb(2.0F));
  EXPECT_THAT(load_with("Kd 0.5 0.5\nKd xyz 1 1 1\n").warnings,
              ElementsAre(AllOf(HasSubstr("\"Kd 0.5 0.5\" is not read"), HasSubstr("\"Kd xyz 1 1 1\" is not read"))));
}

TEST_F(MtlTest, SpellingOfKeywordsAndLines) {
  const Material tabs = material("\tKd\t.5 .25 \\\r\n\t.125\r\n  KS 0 0 0\r\n");
  EXPECT_EQ(tabs.diffuse, colour);
}

TEST_F(MtlTest, HighlightCountsWhereNoModelIsNamed) {
  EXPECT_EQ(material(kd + "Ks 0.1 0.1 0.1\nNs 5\n").bsdf, Bsdf::phong);
  EXPECT_THAT(load_with(kd + "Ks 0.1 0.1 0.1\nNs 5\nillum 1\n").warnings, ElementsAre(HasSubstr("illum 1 leaves out")));
}

TEST_F(MtlTest, OpacityAndTransparency) {
  for (const char* opaque : {"d 1\n", "Tr 0\n", "d 1\nTr 1\n", "Tr 1\nd 1\n", "d -halo 1\n"})
    EXPECT_THAT(load_with(kd + opaque).warnings, IsEmpty()) << opaque;
  for (const char* clear : {"d 0.5\n", "Tr 0.5\n", "illum 4\n"})
    EXPECT_THAT(load_with(kd + clear).warnings, ElementsAre(HasSubstr("transparency is not simulated"))) << clear;
}

TEST_F(MtlTest, WhatIsNotKnownIsNamedOnce) {
  EXPECT_THAT(load_with("map_bump -bm 0.5 b.png\nmap_Pr p.png\n" + kd).warnings,
              ElementsAre(AllOf(HasSubstr("map_bump is not used"), HasSubstr("map_Pr is not used"))));
  EXPECT_THAT(load_with(kd + "Kx 1\nhello\nKx 2\n").warnings,
              ElementsAre(HasSubstr("m.mtl: unknown statements are left out: \"Kx\", \"hello\"")));
  EXPECT_THAT(load_with(kd + "newmtl a\nKd 1 1 1\n").warnings, ElementsAre(HasSubstr("\"a\" is defined twice")));
  EXPECT_THAT(load_with("Ks 0.1 0.1 0.1\n").warnings, ElementsAre(HasSubstr("it has no Kd, 0.6 is used")));
}

class MtlPictureTest : public MtlTest {
 protected:
  /// White on the left half, black on the right.
  MtlPictureTest() { write_png(folder_ / "half white.png", {2, 1, {Rgb(1.0F), Rgb(0.0F)}}); }
};

TEST_F(MtlPictureTest, MeanOverWhatTheMeshUses) {
  EXPECT_NEAR(load_with("Kd 1 1 1\nmap_Kd half white.png\n").materials.at(0).diffuse.r, 0.5F, 1e-4F);
  EXPECT_NEAR(load_with("Kd 1 1 1\nmap_Kd half white.png\n", "0.5").materials.at(0).diffuse.r, 1.0F, 1e-4F);
}

TEST_F(MtlPictureTest, PictureWithoutItsColour) {
  const Scene scene = load_with("map_Kd half white.png\nmap_Ke half white.png\n");
  EXPECT_NEAR(scene.materials.at(0).diffuse.r, 0.5F, 1e-4F);
  EXPECT_NEAR(scene.materials[0].emission.r, 0.5F, 1e-4F);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the picture \"half white.png\" is replaced by its mean")));
}

TEST_F(MtlPictureTest, ScaleOffsetAndClampOfItsPoints) {
  const auto mean = [&](const std::string& options) {
    return load_with("map_Kd " + options + " half white.png\n", "0.5").materials.at(0).diffuse.r;
  };
  EXPECT_NEAR(mean("-s 2 2 2"), 0.5F, 1e-4F);
  EXPECT_NEAR(mean("-o 0.5 0 0"), 0.0F, 1e-4F);
  EXPECT_NEAR(mean("-o 1"), 1.0F, 1e-4F);
  EXPECT_NEAR(mean("-clamp on -o 1"), 0.0F, 1e-4F);
  EXPECT_NEAR(mean("-blendu on -texres 512 -o 0.25"), 0.5F, 1e-4F);
  EXPECT_THAT(load_with("map_Kd -mm 0 2 -bm 1 half white.png\n").warnings, ElementsAre(HasSubstr("map_Kd: left out: -mm -bm")));
}

TEST_F(MtlPictureTest, PathsOfOtherMachines) {
  const Scene scene = load_with("Kd 1 1 1\nmap_Kd C:\\Users\\me\\half white.png\n");
  EXPECT_NEAR(scene.materials.at(0).diffuse.r, 0.5F, 1e-4F);
}

TEST_F(MtlPictureTest, MissingPictureLeavesTheColour) {
  const Scene scene = load_with("map_Kd absent.png\n");
  EXPECT_EQ(scene.materials.at(0).diffuse, Rgb(0.6F));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("absent.png")));
}

TEST_F(MtlPictureTest, SurfaceWithoutTexturePointsHasTheWhole) {
  write_text(folder_ / "m.mtl", "newmtl a\nmap_Kd half white.png\n");
  write_text(folder_ / "m.obj", "mtllib m.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  const Scene scene = load_scene(folder_ / "m.obj");
  EXPECT_NEAR(scene.materials.at(0).diffuse.r, 0.5F, 1e-4F);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("that of the whole")));
}

TEST_F(MtlTest, APictureFollowsItsFileAndWhatIsNotFollowedIsNamed) {
  using namespace png_bytes;
  const std::string stated = chunk("gAMA" + big_endian(100000)) + chunk(std::string("iCCPodd\0\0", 9) + stored("none"));
  write_text(folder_ / "p.png", png(1, 1, 8, 2, stated, stored(std::string("\0\x80\x40\x20", 4))));
  const Scene scene = load_with("map_Kd p.png\n");
  EXPECT_NEAR(scene.materials.at(0).diffuse.r, 128.0F / 255.0F, 1e-6F);
  EXPECT_THAT(scene.warnings,
              ElementsAre(HasSubstr("the picture \"p.png\": its embedded colour profile \"odd\" is not applied")));
}

}  // namespace
}  // namespace gibench::test
