// Damaged, cut and empty models: one line each, through a scene file and alone.
#include <vector>

#include "tests/common/scene_io/scene_text.h"
#include "tests/support/scratch_folder.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
const std::string ply_header =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
const std::string gltf =
    R"({"asset":{"version":"2.0"},"scenes":[{"nodes":[0]}],"scene":0,"nodes":[{"mesh":0}],)"
    R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
    R"("accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]},)"
    R"({"bufferView":1,"componentType":5123,"count":3,"type":"SCALAR"}],)"
    R"("bufferViews":[{"buffer":0,"byteLength":36},{"buffer":0,"byteOffset":36,"byteLength":6}],)"
    R"("buffers":[{"byteLength":42,"uri":"data.bin"}]})";

/// Three vertices of zeros and the indices 0, 1, `last`.
std::string buffer_with_last_index(char last) {
  std::string bytes(36, '\0');
  for (const char index : {'\0', '\1', last}) bytes.append({index, '\0'});
  return bytes;
}

struct BadModel {
  std::string name, file, text, problem;
};

const std::vector<BadModel>& bad_models() {
  static const std::vector<BadModel> cases{
      {"Empty", "m.obj", "", "has no faces"},
      {"NoFaces", "m.obj", square + square, "has no faces"},
      {"OnlyLines", "m.obj", square + "l 1 2\nl 2 3\n", "has no faces"},
      {"IndexPastEnd", "m.obj", square + "f 1 2 9\n", "out of range"},
      {"NanVertex", "m.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n", "is not finite"},
      {"InfiniteVertex", "m.obj", "v 0 0 0\nv 1 0 0\nv inf 1 0\nf 1 2 3\n", "is not finite"},
      {"ObjCutInFace", "m.obj", square + "f 1 2 3\nf 1 2", "cut short: its last line is \"f 1 2\""},
      {"ObjCutInVertex", "m.obj", square + "f 1 2 3\nv 1 0.", "cut short: its last line is \"v 1 0.\""},
      {"PlyCutInVertices", "m.ply", ply_header + "0 0 0\n1 0 0\n",
       "cut short: its header announces 3 records of \"vertex\", and 12 bytes follow"},
      {"PlyCutInFaces", "m.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n", "cut short"},
      {"PlyCutInHeader", "m.ply", ply_header.substr(0, 60), "has no end_header"},
      {"PlyIndexPastEnd", "m.ply", ply_header + "0 0 0\n1 0 0\n1 1 0\n3 0 1 7\n", "has vertex index 7, and there are 3 vertices"},
      {"PlyNan", "m.ply", ply_header + "0 0 0\n1 0 0\n1 nan 0\n3 0 1 2\n", "is not finite"},
      {"StlCut", "m.stl", std::string(80, ' ') + std::string("\2\0\0\0", 4) + std::string(70, '\0'),
       "cut short: it announces 2 facets, and 1 follow"},
      {"StlAsciiCut", "m.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0",
       "cut short: its last line is \"vertex 1 0\""},
      {"GltfWithoutBuffer", "m.gltf", gltf, "data.bin"},
      {"GltfIndexPastEnd", "indices.gltf", gltf, "index out of range"},
      {"GltfBufferCut", "cut.gltf", gltf, "cannot be read"},
      {"GltfNoJson", "m.gltf", gltf.substr(0, 200), "cannot be read"},
      {"GlbCut", "m.glb", std::string("glTF\2\0\0\0\0\1\0\0", 12), "cannot be read"},
      {"NoModel", "m.txt", "hello", "read"},
  };
  return cases;
}

class BadModelTest : public testing::TestWithParam<BadModel> {
 protected:
  void SetUp() override {
    std::string text = GetParam().text;
    const auto use_buffer = [&](const std::string& name, const std::string& bytes) {
      write_text(folder_ / name, bytes);
      text.replace(text.find("data.bin"), 8, name);
    };
    if (GetParam().file == "indices.gltf") use_buffer("indices.bin", buffer_with_last_index('\7'));
    if (GetParam().file == "cut.gltf") use_buffer("cut.bin", buffer_with_last_index('\2').substr(0, 30));
    write_text(folder_ / GetParam().file, text);
  }
  ScratchFolder folder_;
};

TEST_P(BadModelTest, AloneAndInAScene) {
  const auto file = folder_ / GetParam().file;
  const std::string alone = error_of([&] { load_scene(file); });
  EXPECT_THAT(alone, testing::StartsWith(file.string() + ": "));
  EXPECT_THAT(alone, HasSubstr(GetParam().problem));
  EXPECT_THAT(alone, HasSubstr("; "));
  EXPECT_EQ(alone.find_first_of("\n\r"), std::string::npos);

  json scene = quad_scene();
  scene["objects"].push_back({{"name", "statue"}, {"file", GetParam().file}});
  const std::string inside = error_of([&] { load(scene, folder_.path()); });
  EXPECT_THAT(inside, testing::StartsWith("box.scene.json: $.objects[1].file: "));
  EXPECT_THAT(inside, HasSubstr(GetParam().problem));
  EXPECT_EQ(inside.find_first_of("\n\r"), std::string::npos);
}

std::string case_name(const testing::TestParamInfo<BadModel>& info) { return info.param.name; }
INSTANTIATE_TEST_SUITE_P(Damage, BadModelTest, testing::ValuesIn(bad_models()), case_name);

TEST(BadModel, GoodGltfOfTheSameMakeLoads) {
  const ScratchFolder folder;
  write_text(folder / "data.bin", buffer_with_last_index('\2'));
  write_text(folder / "m.gltf", gltf);
  EXPECT_EQ(load_scene(folder / "m.gltf").faces.size(), 1U);
}

TEST(BadModel, FolderIsNoFile) {
  const ScratchFolder folder;
  std::filesystem::create_directories(folder / "rooms.scene.json");
  EXPECT_THAT(error_of([&] { load_scene(folder / "rooms.scene.json"); }), HasSubstr("there is no file"));
}

}  // namespace
}  // namespace gibench::test
