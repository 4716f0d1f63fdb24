// Materials of glTF files: their pictures and vertex colours over what a mesh shows of them, extensions, alpha.
#include <cmath>

#include "common/image/image_file.h"
#include "tests/common/scene_io/gltf/gltf_builder.h"
#include "tests/support/png_bytes.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr float dielectric_share = 0.96F;  // of a dielectric's base colour that is left for its diffuse part
constexpr float rounding_of_8_bits = 4e-3F;

class GltfMaterialsTest : public GltfTest {
 protected:
  /// The square whose base colour is a picture of these linear colours, one row.
  GltfBuilder square_with_picture(const std::vector<Rgb>& row, const std::string& file = "p.png") {
    write_png(folder_ / file, {static_cast<int>(row.size()), 1, row});
    GltfBuilder made = square();
    made.document["images"] = {{{"uri", file}}};
    made.document["textures"] = {{{"source", 0}}};
    made.material()["pbrMetallicRoughness"]["baseColorTexture"] = {{"index", 0}};
    return made;
  }
  Material material_of(const GltfBuilder& made) { return load_document(made).materials.at(0); }
};

void expect_near(const Rgb& actual, const Rgb& expected, float tolerance = 1e-6F) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(actual[c], expected[c], tolerance) << "channel " << c;
}

TEST_F(GltfMaterialsTest, SpecularGlossiness) {
  GltfBuilder made = square();
  made.material()["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
      {"diffuseFactor", {0.5, 0.25, 0.125, 1}}, {"specularFactor", {0.2, 0.1, 0}}, {"glossinessFactor", 0.75}};
  const Scene scene = load_document(made);
  const Material& material = scene.materials.at(0);
  EXPECT_EQ(material.bsdf, Bsdf::ggx);
  expect_near(material.f0, {0.2F, 0.1F, 0.0F});
  expect_near(material.diffuse, Rgb(0.5F, 0.25F, 0.125F) * 0.8F);
  EXPECT_FLOAT_EQ(material.roughness, 0.25F);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST_F(GltfMaterialsTest, VertexColoursAreMultipliedInAsTheirMeanByArea) {
  GltfBuilder made = square();
  made.material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 0.5, 1, 1};
  made.primitive()["attributes"]["COLOR_0"] =
      made.accessor(std::vector<float>{0.5, 0.5, 0, 1, 0.5, 0.5, 0, 1, 0.5, 0.5, 0, 1, 0.5, 0.5, 0.6F, 1}, 4);
  const Scene scene = load_document(made);
  // The last corner is in one of two equal triangles: a sixth of its blue.
  expect_near(scene.materials.at(0).diffuse, Rgb(0.5F, 0.25F, 0.1F) * dielectric_share);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("vertex colours are replaced by their mean")));
}

TEST_F(GltfMaterialsTest, AColourThatIsNotANumberIsClamped) {
  GltfBuilder made = square();
  made.primitive()["attributes"]["COLOR_0"] = made.accessor(std::vector<float>(16, NAN), 4);
  const Scene scene = load_document(made);
  expect_near(scene.materials.at(0).diffuse, Rgb());
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("is clamped to its range")));
}

TEST_F(GltfMaterialsTest, VertexColoursOfNormalisedBytes) {
  GltfBuilder made = square();
  const std::size_t colours = made.accessor(std::vector<std::uint8_t>(16, 51), 4);
  made.document["accessors"][colours]["normalized"] = true;
  made.primitive()["attributes"]["COLOR_0"] = colours;
  expect_near(material_of(made).diffuse, Rgb(0.2F * dielectric_share));
}

TEST_F(GltfMaterialsTest, OneMaterialOnTwoMeshesIsTwoWhereTheyShowItDifferently) {
  GltfBuilder made = square();
  json other = made.primitive(), same = made.primitive();
  other["attributes"]["COLOR_0"] = made.accessor(std::vector<float>(16, 0.5F), 4);
  made.document["meshes"][0]["primitives"].push_back(other);
  made.document["meshes"][0]["primitives"].push_back(same);
  const Scene scene = load_document(made);
  ASSERT_EQ(scene.materials.size(), 2U);
  expect_near(scene.materials[0].diffuse, Rgb(dielectric_share));
  expect_near(scene.materials[1].diffuse, Rgb(0.5F * dielectric_share));
  EXPECT_EQ(scene.materials[1].name, "m#2");
  EXPECT_EQ(scene.objects.at(2).material, scene.objects.at(0).material);
}

TEST_F(GltfMaterialsTest, MetalAndRoughnessOfAPicture) {
  // Levels as they stand, without the curve of sRGB: what is written here as linear is decoded again by that curve.
  GltfBuilder made = square_with_picture({Rgb(1.0F), {0.0F, 1.0F, 0.0F}}, "mr.png");
  json& values = made.material()["pbrMetallicRoughness"];
  values = {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}, {"roughnessFactor", 0.5}, {"metallicRoughnessTexture", {{"index", 0}}}};
  const Material half = material_of(made);
  EXPECT_FLOAT_EQ(half.roughness, 0.5F);
  expect_near(half.f0, Rgb(0.02F) + Rgb(0.25F, 0.125F, 0.0625F));
  expect_near(half.diffuse, Rgb(0.5F, 0.25F, 0.125F) * (0.5F * dielectric_share));
  write_png(folder_ / "mr.png", {1, 1, {{0.0F, 0.2158605F, 0.0F}}});  // level 128 of 255 in green
  const Material none = material_of(made);
  EXPECT_NEAR(none.roughness, 0.5F * 128.0F / 255.0F, 1e-6F);
  expect_near(none.diffuse, Rgb(0.5F, 0.25F, 0.125F) * dielectric_share);
}

TEST_F(GltfMaterialsTest, MeanOverWhatTheMeshShows) {
  GltfBuilder made = square_with_picture({Rgb(1.0F), Rgb(0.0F)});
  expect_near(material_of(made).diffuse, Rgb(0.5F * dielectric_share), rounding_of_8_bits);
  made.primitive()["attributes"]["TEXCOORD_0"] = made.accessor(std::vector<float>{0, 1, 0.5, 1, 0.5, 0, 0, 0}, 2);
  expect_near(material_of(made).diffuse, Rgb(dielectric_share), rounding_of_8_bits);
  made.document["images"][0]["uri"] = "p%2Epng";
  expect_near(material_of(made).diffuse, Rgb(dielectric_share), rounding_of_8_bits);
}

TEST_F(GltfMaterialsTest, EmissionIsTheMeanOverWhatTheMeshShows) {
  GltfBuilder made = square_with_picture({Rgb(0.0F), Rgb(0.0F), Rgb(0.0F), Rgb(1.0F)});
  made.material() = {{"name", "lamp"}, {"emissiveFactor", {1, 1, 1}}, {"emissiveTexture", {{"index", 0}}}};
  made.primitive()["attributes"]["TEXCOORD_0"] = made.accessor(std::vector<float>{0.75, 1, 1, 1, 1, 0, 0.75, 0}, 2);
  expect_near(material_of(made).emission, Rgb(1.0F), rounding_of_8_bits);
}

TEST_F(GltfMaterialsTest, CoordinatesAreTransformed) {
  // Four texels: the lower left one is red.
  GltfBuilder made = square();
  const Rgb red(1.0F, 0.0F, 0.0F), blue(0.0F, 0.0F, 1.0F);
  write_png(folder_ / "p.png", {2, 2, {blue, blue, red, blue}});
  made.document["images"] = {{{"uri", "p.png"}}};
  made.document["textures"] = {{{"source", 0}}};
  json& texture = made.material()["pbrMetallicRoughness"]["baseColorTexture"];
  texture = {{"index", 0}};
  // The example of the extension's text: "only the lower left quadrant of the source image, rotated clockwise 90 degrees".
  texture["extensions"]["KHR_texture_transform"] = {{"offset", {0, 1}}, {"rotation", 1.57079632679}, {"scale", {0.5, 0.5}}};
  expect_near(material_of(made).diffuse, red * dielectric_share, rounding_of_8_bits);
  texture["extensions"]["KHR_texture_transform"] = {{"offset", {0.5, 0.5}}, {"scale", {0.5, 0.5}}};
  expect_near(material_of(made).diffuse, blue * dielectric_share, rounding_of_8_bits);
  // Another set of coordinates, all in the red texel.
  made.primitive()["attributes"]["TEXCOORD_1"] = made.accessor(std::vector<float>{0, 1, 0.5, 1, 0.5, 0.5, 0, 0.5}, 2);
  texture["extensions"]["KHR_texture_transform"] = {{"texCoord", 1}};
  expect_near(material_of(made).diffuse, red * dielectric_share, rounding_of_8_bits);
}

TEST_F(GltfMaterialsTest, SamplersCarryOnThePicture) {
  GltfBuilder made = square_with_picture({Rgb(1.0F), Rgb(0.0F)});
  made.primitive()["attributes"]["TEXCOORD_0"] = made.accessor(std::vector<float>{1, 1, 1.5, 1, 1.5, 0, 1, 0}, 2);
  expect_near(material_of(made).diffuse, Rgb(dielectric_share), rounding_of_8_bits);
  made.document["samplers"] = {{{"wrapS", 33071}}};
  made.document["textures"][0]["sampler"] = 0;
  expect_near(material_of(made).diffuse, Rgb(0.0F), rounding_of_8_bits);
}

// glTF 2.0, 3.8.3: what pictures state of their colours must be ignored.
TEST_F(GltfMaterialsTest, PicturesAreSrgbWhateverTheyState) {
  using namespace png_bytes;
  GltfBuilder made = square_with_picture({Rgb(0.0F)});
  const std::string linear = chunk("gAMA" + big_endian(100000)) + chunk(std::string("iCCPodd\0\0", 9) + stored("none"));
  write_text(folder_ / "p.png", png(1, 1, 8, 2, linear, stored(std::string("\0\x80\x80\x80", 4))));
  const Scene scene = load_document(made);
  expect_near(scene.materials.at(0).diffuse, Rgb(0.2158605F) * dielectric_share);
  EXPECT_THAT(scene.warnings, ElementsAre(testing::Not(HasSubstr("profile"))));
}

TEST_F(GltfMaterialsTest, APictureInsideTheFileNeedsNoOtherFile) {
  GltfBuilder made = square_with_picture({Rgb(1.0F, 0.0F, 0.0F)});
  made.document["images"][0] = {{"bufferView", made.view(bytes_of(folder_ / "p.png"))}, {"mimeType", "image/png"}};
  const ScratchFolder empty;
  std::string before = std::filesystem::temp_directory_path().string();
  setenv("TMPDIR", (empty / "missing").string().c_str(), 1);
  const Material material = material_of(made);
  setenv("TMPDIR", before.c_str(), 1);
  expect_near(material.diffuse, Rgb(1.0F, 0.0F, 0.0F) * dielectric_share, rounding_of_8_bits);
}

TEST_F(GltfMaterialsTest, PicturesThatCannotBeReadAreNamed) {
  GltfBuilder made = square_with_picture({Rgb(0.5F)});
  made.document["textures"][0] = {{"extensions", {{"KHR_texture_basisu", {{"source", 0}}}}}};
  EXPECT_THAT(load_document(made).warnings, testing::UnorderedElementsAre(HasSubstr("textures[0] names none outside extensions"),
                                                                          HasSubstr("KHR_texture_basisu")));
  made.document["textures"][0]["source"] = 0;
  expect_near(material_of(made).diffuse, Rgb(0.5F * dielectric_share), rounding_of_8_bits);
  made.document["textures"][0] = {{"source", 0}};
  made.document["images"][0]["uri"] = "missing.png";
  const Scene scene = load_document(made);
  EXPECT_THAT(scene.warnings, ElementsAre(testing::AllOf(HasSubstr("a picture is not used"), HasSubstr("missing.png"))));
  expect_near(scene.materials.at(0).diffuse, Rgb(dielectric_share));
}

TEST_F(GltfMaterialsTest, AlphaCountsByItsMode) {
  GltfBuilder made = square();
  made.primitive()["attributes"]["COLOR_0"] = made.accessor(std::vector<float>(16, 0.25F), 4);
  made.material()["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 1, 0.5};
  const auto warning = HasSubstr("transparency is not simulated, the surface is opaque");
  EXPECT_THAT(load_document(made).warnings, testing::Not(testing::Contains(warning))) << "OPAQUE ignores alpha";
  for (const char* mode : {"BLEND", "MASK"}) {
    made.material()["alphaMode"] = mode;
    EXPECT_THAT(load_document(made).warnings, testing::Contains(testing::AllOf(warning, HasSubstr(mode))));
  }
  made.material()["alphaCutoff"] = 0.1;
  EXPECT_THAT(load_document(made).warnings, testing::Not(testing::Contains(warning))) << "nothing is below the cut-off";
}

TEST_F(GltfMaterialsTest, UnlitEmitsItsBaseColour) {
  GltfBuilder made = square();
  made.material()["pbrMetallicRoughness"]["baseColorFactor"] = {0.5, 0.25, 0.125, 1};
  made.material()["extensions"]["KHR_materials_unlit"] = json::object();
  const Scene scene = load_document(made);
  expect_near(scene.materials.at(0).emission, {0.5F, 0.25F, 0.125F});
  EXPECT_TRUE(is_black(scene.materials[0].diffuse));
  EXPECT_EQ(scene.materials[0].bsdf, Bsdf::diffuse);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("unlit")));
}

TEST_F(GltfMaterialsTest, IndexOfRefractionAndSpecularColour) {
  GltfBuilder made = square();
  made.material()["extensions"]["KHR_materials_ior"] = {{"ior", 2}};
  const Material glass = material_of(made);
  expect_near(glass.f0, Rgb(1.0F / 9.0F));
  expect_near(glass.diffuse, Rgb(8.0F / 9.0F));
  made.material()["extensions"]["KHR_materials_specular"] = {{"specularFactor", 0.5}, {"specularColorFactor", {1, 0.5, 0}}};
  expect_near(material_of(made).f0, Rgb(1.0F, 0.5F, 0.0F) / 18.0F);
}

TEST_F(GltfMaterialsTest, EverythingThatIsNotUsedIsNamed) {
  GltfBuilder made = square();
  made.document["extensionsUsed"] = json::array({"EXT_listed", "KHR_materials_clearcoat"});
  made.document["animations"] = json::array({json::object()});
  made.document["skins"] = json::array({json::object()});
  made.document["nodes"][0]["skin"] = 0;
  made.material()["extensions"]["KHR_materials_sheen"] = json::object();
  made.material()["normalTexture"] = {{"index", 0}};
  made.material()["extras"]["extensions"]["NOT_an_extension"] = 1;
  const Scene scene = load_document(made);
  EXPECT_THAT(scene.warnings,
              testing::UnorderedElementsAre(
                  HasSubstr("normal picture is not used"),
                  HasSubstr("not used: EXT_listed, KHR_materials_clearcoat, KHR_materials_sheen, skins (meshes stand as their "
                            "nodes put them), animations")));
}

TEST_F(GltfMaterialsTest, WithoutAMaterialAGreyIsUsedWithAWarning) {
  GltfBuilder made = square();
  made.primitive().erase("material");
  const Scene scene = load_document(made);
  EXPECT_EQ(scene.materials.at(0).diffuse, Rgb(0.6F));
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("no material")));
}

}  // namespace
}  // namespace gibench::test
