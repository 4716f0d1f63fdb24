// OBJ, PLY and STL models: geometry as the file has it, materials of MTL files, models as objects of a scene.
#include <cmath>

#include "common/image/image_file.h"
#include "tests/common/scene_io/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<std::string> object_names(const Scene& scene) {
  std::vector<std::string> names;
  for (const Object& object : scene.objects) names.push_back(object.name);
  return names;
}

class ModelFileTest : public testing::Test {
 protected:
  Scene load_text(const std::string& name, const std::string& text) {
    write_text(folder_ / name, text);
    return load_scene(folder_ / name);
  }
  /// A square with a material of these MTL lines.
  Scene load_with_mtl(const std::string& lines) {
    write_text(folder_ / "m.mtl", "newmtl paint\n" + lines);
    return load_text("m.obj", "mtllib m.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  }
  ScratchFolder folder_;
};

TEST_F(ModelFileTest, ObjKeepsQuadsAndReadsRelativeIndicesAndTabs) {
  const Scene scene = load_text("box.obj",
                                "v\t0 0 0\nv\t1\t0\t0\nv 1 1 0   \nv\t 0 1 0\nf -4 -3 -2 -1\n"
                                "v 2 0 0\nv 2 1 0\nf -5 -2 -1\n");
  ASSERT_EQ(scene.faces.size(), 2U);
  EXPECT_TRUE(scene.faces[0].is_quad());
  EXPECT_FALSE(scene.faces[1].is_quad());
  EXPECT_EQ(scene.vertices.size(), 6U);
  EXPECT_NEAR(area_of(scene), 1.5, 1e-6);
  EXPECT_EQ(scene.name, "box");
  EXPECT_EQ(scene.file, folder_ / "box.obj");
}

TEST_F(ModelFileTest, ObjVerticesAreJoinedByPosition) {
  const Scene scene = load_text("fan.obj",
                                "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvn 0 1 0\n"
                                "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\nf 2 2 3\n");
  EXPECT_EQ(scene.vertices.size(), 4U);
  EXPECT_EQ(scene.faces.size(), 3U);  // the degenerate one among them
}

TEST_F(ModelFileTest, LargePolygonsAreTriangulatedAndSmallFacesStay) {
  // An L of six corners (area 3), a convex pentagon (area 1.5), a quad and a triangle, with two lines.
  const Scene scene = load_text("polygons.obj",
                                "v 0 0 0\nv 2 0 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4 5 6\n"
                                "v 5 0 0\nv 6 0 0\nv 6 1 0\nv 5.5 2 0\nv 5 1 0\nf 7 8 9 10 11\n"
                                "f 1 2 3 4\nf 1 2 3\nl 1 2\nl 2 3\n");
  std::size_t quads = 0;
  for (const Face& face : scene.faces) quads += face.is_quad() ? 1U : 0U;
  EXPECT_EQ(quads, 1U);
  EXPECT_EQ(scene.faces.size(), 1U + 1U + 4U + 3U);
  EXPECT_NEAR(area_of(scene), 3.0 + 1.5 + 1.5 + 1.0, 1e-5);
  for (const Triangle& t : scene.triangles) {
    const Vec3 a = scene.vertices[t.corners[0]], b = scene.vertices[t.corners[1]], c = scene.vertices[t.corners[2]];
    EXPECT_GT(glm::cross(b - a, c - a).z, 0.0F);  // all fronts up
  }
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("2 points and lines are left out")));
}

TEST_F(ModelFileTest, FarTextModelsKeepDoublePrecision) {
  const auto obj = [](const std::string& x, const std::string& y) {
    return "v " + x + ".125 " + y + ".25 0.5\nv " + x + ".625 " + y + ".25 0.5 1 1 1\nv " + x + ".625 " + y +
           ".765625 0.5\nf 1 2 3\n";
  };
  const auto stl = [](const std::string& x) {
    return "solid s\nfacet normal 0 0 1\n outer loop\n  vertex " + x + ".125 0.25 0.5\n  vertex " + x +
           ".625 0.25 0.5\n  vertex " + x + ".625 0.765625 0.5\n endloop\nendfacet\nendsolid s\n";
  };
  const Scene near = load_text("near.obj", obj("0", "0"));
  for (const auto& [name, text, shift] : {std::tuple("far.obj", obj("100000", "300000"), Vec3d(1e5, 3e5, 0)),
                                          std::tuple("farther.obj", obj("123456789", "0"), Vec3d(123456789, 0, 0)),
                                          std::tuple("far.stl", stl("100000"), Vec3d(1e5, 0, 0))}) {
    const Scene far = load_text(name, text);
    EXPECT_EQ(far.vertices, near.vertices) << name;
    EXPECT_LT(glm::length(far.origin - near.origin - shift), 1e-7) << name;
    EXPECT_THAT(far.warnings, testing::Not(testing::Contains(HasSubstr("single precision")))) << name;
  }
  const Scene ply = load_text("far.ply",
                              "ply\nformat ascii 1.0\nelement vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
                              "element face 1\nproperty list uchar int vertex_indices\nend_header\n"
                              "100000.125 0.25 0.5\n100000.625 0.25 0.5\n100000.625 0.765625 0.5\n3 0 1 2\n");
  EXPECT_EQ(ply.vertices, near.vertices);
  EXPECT_THAT(ply.warnings, ElementsAre(HasSubstr("no material")));
}

TEST_F(ModelFileTest, MtlMaterials) {
  const Scene diffuse = load_with_mtl("Kd 0.5 0.25 0.125\nKs 0 0 0\nKe 17 12 4\nillum 2\n");
  EXPECT_EQ(diffuse.materials.at(0).name, "paint");
  EXPECT_EQ(diffuse.materials[0].bsdf, Bsdf::diffuse);
  EXPECT_EQ(diffuse.materials[0].diffuse, Rgb(0.5F, 0.25F, 0.125F));
  EXPECT_EQ(diffuse.materials[0].emission, Rgb(17, 12, 4));
  EXPECT_TRUE(diffuse.warnings.empty());
  const Scene phong = load_with_mtl("Kd 0.5 0.25 0.125\nKs 0.25 0.5 0.125\nNs 40\nillum 2\n");
  EXPECT_EQ(phong.materials[0].bsdf, Bsdf::phong);
  EXPECT_EQ(phong.materials[0].specular, Rgb(0.25F, 0.5F, 0.125F));
  EXPECT_EQ(phong.materials[0].exponent, 40.0F);
  const Scene mirror = load_with_mtl("Kd 0.01 0.01 0.01\nKs 0.95 0.95 0.95\nNs 1000\nillum 5\n");
  EXPECT_EQ(mirror.materials[0].bsdf, Bsdf::mirror);
  EXPECT_EQ(mirror.materials[0].reflectance, Rgb(0.95F));
}

TEST_F(ModelFileTest, OutOfRangeMaterialsAreClampedWithOneWarning) {
  const Scene bright = load_with_mtl("Kd 1.5 0.5 -0.5\nKs 0 0 0\nillum 2\n");
  EXPECT_EQ(bright.materials[0].diffuse, Rgb(1.0F, 0.5F, 0.0F));
  EXPECT_THAT(bright.warnings, ElementsAre(HasSubstr("material \"paint\": the diffuse colour is clamped")));
  const Scene energetic = load_with_mtl("Kd 0.75 0.5 0.5\nKs 0.75 0.1 0.1\nNs 5\nd 0.5\nillum 2\n");
  EXPECT_LE(largest(energetic.materials[0].diffuse + energetic.materials[0].specular), 1.0F);
  EXPECT_NEAR(energetic.materials[0].diffuse.g, 0.5F / 1.5F, 1e-6F);
  ASSERT_EQ(energetic.warnings.size(), 1U);
  EXPECT_THAT(energetic.warnings[0], HasSubstr("above 1 and is scaled down"));
  EXPECT_THAT(energetic.warnings[0], HasSubstr("transparency is not simulated"));
}

TEST_F(ModelFileTest, PicturesAreReplacedByTheirLinearMean) {
  write_png(folder_ / "checks.png", {2, 2, {Rgb(1.0F), Rgb(0.0F), Rgb(0.0F), Rgb(1.0F)}});
  const Scene scene = load_with_mtl("Kd 0.8 0.4 0.2\nmap_Kd checks.png\n");
  EXPECT_NEAR(scene.materials[0].diffuse.r, 0.4F, 1e-4F);
  EXPECT_NEAR(scene.materials[0].diffuse.g, 0.2F, 1e-4F);
  EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("the picture \"checks.png\" is replaced by its mean")));
  const Scene without = load_with_mtl("Kd 0.8 0.4 0.2\nmap_Kd absent.png\n");
  EXPECT_EQ(without.materials[0].diffuse, Rgb(0.8F, 0.4F, 0.2F));
  EXPECT_THAT(without.warnings, ElementsAre(HasSubstr("absent.png")));
}

TEST_F(ModelFileTest, AbsentMtlIsAWarning) {
  const Scene scene = load_text("m.obj", "mtllib absent.mtl\nusemtl paint\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n");
  EXPECT_THAT(scene.warnings, testing::Contains(HasSubstr("absent.mtl")));
  EXPECT_EQ(scene.material_of_object(0).bsdf, Bsdf::diffuse);
}

constexpr const char* two_materials =
    "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\no top\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 3 4\no bottom\nusemtl "
    "red\nf 3 2 1\n";

TEST_F(ModelFileTest, BareModelHasOneObjectForEachNodeAndMaterial) {
  write_text(folder_ / "two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\nnewmtl unused\nKd 0 1 0\n");
  const Scene scene = load_text("two.obj", two_materials);
  EXPECT_THAT(object_names(scene), ElementsAre("top/red", "top/blue", "bottom/red"));
  EXPECT_EQ(scene.materials.size(), 2U);
  EXPECT_EQ(scene.material_of_object(1).diffuse, Rgb(0, 0, 1));
}

TEST_F(ModelFileTest, ObjectWithoutMaterialIsSplitByTheModelsOwn) {
  write_text(folder_ / "two.mtl", "newmtl red\nKd 1 0 0\nnewmtl blue\nKd 0 0 1\n");
  write_text(folder_ / "two.obj", two_materials);
  json text = quad_scene();
  text["objects"].push_back(
      {{"name", "statue"}, {"file", "two.obj"}, {"two_sided", true}, {"group", "g"}, {"translate", {0, 0, 5}}});
  text["edits"] = {{{"move", "statue"}}, {{"material", "statue/red"}, {"albedo", 0.5}}};
  const Scene scene = load(text, folder_.path());
  EXPECT_THAT(object_names(scene), ElementsAre("floor", "statue/red", "statue/blue"));
  EXPECT_EQ(scene.material_of_object(1).name, "statue/red");
  EXPECT_EQ(scene.material_of_object(2).diffuse, Rgb(0, 0, 1));
  EXPECT_TRUE(scene.objects[2].two_sided);
  EXPECT_EQ(scene.objects[2].group, "g");
  EXPECT_EQ(scene.objects[1].face_end - scene.objects[1].face_begin, 2U);
  EXPECT_FLOAT_EQ(scene.vertices[scene.objects[1].vertex_begin].z, 2.5F);  // halfway between z = 0 and 5

  text["objects"][1]["material"] = "white";
  text.erase("edits");
  const Scene painted = load(text, folder_.path());
  EXPECT_THAT(object_names(painted), ElementsAre("floor", "statue"));
  EXPECT_EQ(painted.materials.size(), 1U);
}

TEST_F(ModelFileTest, ModelsAreFoundThroughGibenchPath) {
  std::filesystem::create_directories(folder_ / "library/stones");
  write_text(folder_ / "library/stones/slab.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
  json text = quad_scene();
  text["objects"].push_back({{"name", "slab"}, {"file", "stones/slab.obj"}, {"material", "white"}});
  setenv("GIBENCH_PATH", ("/no/such/folder:" + (folder_ / "library").string()).c_str(), 1);
  const Scene scene = load(text, folder_.path());
  const Scene bare = load_scene("stones/slab.obj");
  unsetenv("GIBENCH_PATH");
  EXPECT_EQ(scene.faces.size(), 2U);
  EXPECT_EQ(bare.faces.size(), 1U);
}

TEST_F(ModelFileTest, PlyAsciiAndBinary) {
  const std::string header =
      "element vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 2\n"
      "property list uchar int vertex_indices\nend_header\n";
  const Scene ascii = load_text("a.ply", "ply\nformat ascii 1.0\n" + header + "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2\n");
  ASSERT_EQ(ascii.faces.size(), 2U);
  EXPECT_TRUE(ascii.faces[0].is_quad());
  EXPECT_EQ(ascii.vertices.size(), 4U);
  EXPECT_FALSE(ascii.objects[0].two_sided);
  EXPECT_THAT(ascii.warnings, ElementsAre(HasSubstr("no material")));

  std::string data = "ply\nformat binary_little_endian 1.0\n" + header;
  const auto put = [&data](auto value) { data.append(reinterpret_cast<const char*>(&value), sizeof value); };
  for (const float x : {0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F, 0.F, 1.F, 0.F}) put(x);
  put(static_cast<unsigned char>(4));
  for (const int i : {0, 1, 2, 3}) put(i);
  put(static_cast<unsigned char>(3));
  for (const int i : {0, 1, 2}) put(i);
  const Scene binary = load_text("b.ply", data);
  EXPECT_EQ(binary.vertices, ascii.vertices);
  ASSERT_EQ(binary.faces.size(), 2U);
  EXPECT_TRUE(binary.faces[0].is_quad());
}

TEST_F(ModelFileTest, StlAsciiAndBinary) {
  const Scene ascii =
      load_text("a.stl",
                "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n"
                "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
  EXPECT_EQ(ascii.vertices.size(), 4U);  // joined
  EXPECT_EQ(ascii.faces.size(), 2U);
  std::string data(80, ' ');
  const auto put = [&data](auto value) { data.append(reinterpret_cast<const char*>(&value), sizeof value); };
  put(std::uint32_t{1});
  for (const float x : {0.F, 0.F, 1.F, 0.F, 0.F, 0.F, 1.F, 0.F, 0.F, 1.F, 1.F, 0.F}) put(x);
  put(std::uint16_t{0});
  const Scene binary = load_text("b.stl", data);
  EXPECT_NEAR(area_of(binary), 0.5, 1e-6);
}

}  // namespace
}  // namespace gibench::test
