// Numbers of glTF buffers: quantised, normalised, sparse, strided; kinds of primitives; lengths and offsets that do not fit.
#include "tests/common/scene_io/gltf/gltf_builder.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class GltfBuffersTest : public GltfTest {};

/// The square with other positions, x and y at their lowest and highest.
template <class T>
GltfBuilder quantised(T low, T high, bool normalised) {
  GltfBuilder made = square();
  made.document["extensionsUsed"] = made.document["extensionsRequired"] = json::array({"KHR_mesh_quantization"});
  // Rows are padded to four numbers, as glTF asks of vertex attributes.
  const std::size_t positions =
      made.accessor(std::vector<T>{low, low, 0, 9, high, low, 0, 9, high, high, 0, 9, low, high, 0, 9}, 4);
  json& accessor = made.document["accessors"][positions];
  accessor["type"] = "VEC3";
  accessor["normalized"] = normalised;
  made.document["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteStride"] = 4 * sizeof(T);
  made.primitive()["attributes"]["POSITION"] = positions;
  return made;
}

TEST_F(GltfBuffersTest, QuantisedPositions) {
  EXPECT_NEAR(area_of(load_document(quantised<std::uint16_t>(0, 100, false))), 10000.0, 1e-3);
  EXPECT_NEAR(area_of(load_document(quantised<std::int8_t>(-64, 64, true))), (128.0 / 127.0) * (128.0 / 127.0), 1e-6);
  EXPECT_NEAR(area_of(load_document(quantised<std::int16_t>(-32767, 32767, true))), 4.0, 1e-6);
  EXPECT_NEAR(area_of(load_document(quantised<std::int16_t>(-32768, 32767, true))), 4.0, 1e-6) << "the lowest is -1 too";
  EXPECT_NEAR(area_of(load_document(quantised<std::uint8_t>(0, 255, true))), 1.0, 1e-6);
}

TEST_F(GltfBuffersTest, SparseValuesTakeTheirPlaces) {
  GltfBuilder made = square();
  json& accessor = made.document["accessors"][made.primitive()["attributes"]["POSITION"].get<std::size_t>()];
  const std::size_t places = made.view(std::vector<std::uint8_t>{1, 2});
  const std::size_t values = made.view(std::vector<float>{3, -1, 0, 3, 1, 0});
  accessor["sparse"] = {
      {"count", 2}, {"indices", {{"bufferView", places}, {"componentType", 5121}}}, {"values", {{"bufferView", values}}}};
  EXPECT_NEAR(area_of(load_document(made)), 8.0, 1e-6);
  accessor["sparse"]["indices"]["bufferView"] = made.view(std::vector<std::uint8_t>{1, 4});
  EXPECT_THAT(error_of_document(made), HasSubstr("sparse.indices has index 4"));
}

TEST_F(GltfBuffersTest, AnAccessorWithoutABufferIsZeros) {
  GltfBuilder made = square();
  json& accessor = made.document["accessors"][made.primitive()["attributes"]["POSITION"].get<std::size_t>()];
  accessor.erase("bufferView");
  accessor["sparse"] = {{"count", 2},
                        {"indices", {{"bufferView", made.view(std::vector<std::uint8_t>{1, 2})}, {"componentType", 5121}}},
                        {"values", {{"bufferView", made.view(std::vector<float>{3, 0, 0, 3, 1, 0})}}}};
  EXPECT_NEAR(area_of(load_document(made)), 1.5, 1e-6);
  accessor["count"] = 1e12;
  EXPECT_THAT(error_of_document(made), HasSubstr("rows without data"));
  accessor["count"] = 4;
  accessor.erase("sparse");
  EXPECT_THAT(error_of_document(made), HasSubstr("has no data"));
}

TEST_F(GltfBuffersTest, StripsAndFansTurnOneWay) {
  for (const auto& [mode, order] : {std::pair{5, std::vector<std::uint8_t>{0, 1, 3, 2}}, {6, {0, 1, 2, 3}}}) {
    GltfBuilder made = square();
    made.primitive()["mode"] = mode;
    made.primitive()["indices"] = made.accessor(order, 1);
    const Scene scene = load_document(made);
    ASSERT_EQ(scene.triangles.size(), 2U) << mode;
    for (const Triangle& triangle : scene.triangles) {
      const auto& [a, b, c] = triangle.corners;
      EXPECT_GT(glm::cross(scene.vertices[b] - scene.vertices[a], scene.vertices[c] - scene.vertices[a]).z, 0.0F) << mode;
    }
  }
}

TEST_F(GltfBuffersTest, WithoutIndicesCornersAreInOrderAndJoined) {
  GltfBuilder made = square();
  made.primitive().erase("indices");
  made.primitive()["attributes"] = {
      {"POSITION", made.accessor(std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, -0.0F, 0, 0, 1, 1, 0, 0, 1, 0}, 3)}};
  const Scene scene = load_document(made);
  EXPECT_NEAR(area_of(scene), 1.0, 1e-6);
  EXPECT_EQ(scene.vertices.size(), 4U);
}

TEST_F(GltfBuffersTest, PointsAndLinesAreNamedAndLeftOut) {
  GltfBuilder made = square();
  json lines = made.primitive();
  lines["mode"] = 1;
  made.document["meshes"][0]["primitives"].push_back(lines);
  const Scene scene = load_document(made);
  EXPECT_EQ(scene.triangles.size(), 2U);
  EXPECT_THAT(scene.warnings, testing::ElementsAre(HasSubstr("not used: 1 primitives of points and lines")));
}

TEST_F(GltfBuffersTest, MorphTargetsMoveByTheWeightsOfTheNodeOrElseOfTheMesh) {
  GltfBuilder made = square();
  const std::size_t wider = made.accessor(std::vector<float>{0, 0, 0, 2, 0, 0, 2, 0, 0, 0, 0, 0}, 3);
  made.primitive()["targets"] = {{{"POSITION", wider}}};
  EXPECT_NEAR(area_of(load_document(made)), 4.0, 1e-6);
  made.document["meshes"][0]["weights"] = {0.5};
  EXPECT_NEAR(area_of(load_document(made)), 6.0, 1e-6);
  made.document["nodes"][0]["weights"] = {1};
  EXPECT_NEAR(area_of(load_document(made)), 8.0, 1e-6);
}

TEST_F(GltfBuffersTest, UrisArePercentEncoded) {
  GltfBuilder made = square();
  write_text(folder_ / "my buf%.bin", made.buffer);
  made.document["buffers"][0]["uri"] = "my%20buf%25.bin";
  write_text(folder_ / "m.gltf", made.document.dump());
  EXPECT_EQ(load_scene(folder_ / "m.gltf").triangles.size(), 2U);
}

TEST_F(GltfBuffersTest, DataInsideTheUri) {
  GltfBuilder made = square();
  made.primitive()["attributes"] = {{"POSITION", 0}};
  made.primitive().erase("indices");
  // 0 0 0, 1 0 0, 0 1 0 as floats.
  made.document["buffers"] = {
      {{"byteLength", 36}, {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}};
  made.document["bufferViews"][0] = {{"buffer", 0}, {"byteLength", 36}};
  made.document["accessors"][0]["count"] = 3;
  write_text(folder_ / "m.gltf", made.document.dump());
  EXPECT_NEAR(area_of(load_scene(folder_ / "m.gltf")), 0.5, 1e-6);
  made.document["buffers"][0]["uri"] = "data:application/octet-stream;base64,AAAA?AAA";
  write_text(folder_ / "m.gltf", made.document.dump());
  EXPECT_THAT(error_of([&] { load_scene(folder_ / "m.gltf"); }), HasSubstr("buffers[0].uri is a data: URI that is not base64"));
}

struct Misfit {
  std::string name, pointer;
  json value;
  std::string problem;
};

class GltfMisfitTest : public testing::TestWithParam<Misfit> {};

// Every number that a file gives is held against what is there, before memory is taken for it.
TEST_P(GltfMisfitTest, IsRefusedByItsPlace) {
  const ScratchFolder folder;
  GltfBuilder made = square();
  made.document[json::json_pointer(GetParam().pointer)] = GetParam().value;
  made.write(folder / "m.gltf");
  EXPECT_THAT(error_of([&] { load_scene(folder / "m.gltf"); }), HasSubstr(GetParam().problem));
}

INSTANTIATE_TEST_SUITE_P(
    All, GltfMisfitTest,
    testing::Values(Misfit{"CountOfAnAccessor", "/accessors/0/count", 5, "accessors[0] has 5 rows"},
                    Misfit{"HugeCount", "/accessors/0/count", 1000000000000000, "accessors[0] has 1000000000000000 rows"},
                    Misfit{"NegativeCount", "/accessors/0/count", -1, "accessors[0].count is not a whole number"},
                    Misfit{"TextForACount", "/accessors/0/count", "4", "accessors[0].count is not a number"},
                    Misfit{"Offset", "/accessors/0/byteOffset", 8, "accessors[0] has 4 rows"},
                    Misfit{"ViewsLength", "/bufferViews/0/byteLength", 4000, "bufferViews[0] ends at byte 4000"},
                    Misfit{"ViewsOffset", "/bufferViews/2/byteOffset", 9007199254740992, "bufferViews[2] ends at byte"},
                    Misfit{"ViewsBuffer", "/bufferViews/0/buffer", 3, "buffers has no element 3"},
                    Misfit{"BuffersLength", "/buffers/0/byteLength", 4000, "buffers[0] announces 4000 bytes and there are"},
                    Misfit{"ComponentType", "/accessors/0/componentType", 5124, "5124, which is no component type"},
                    Misfit{"Type", "/accessors/0/type", "MAT4", "accessors[0].type is \"MAT4\""},
                    Misfit{"PositionsOfTwoNumbers", "/meshes/0/primitives/0/attributes/POSITION", 1,
                           "2 numbers per vertex, not 3"},
                    Misfit{"MissingAccessor", "/meshes/0/primitives/0/attributes/POSITION", 9, "accessors has no element 9"},
                    Misfit{"IndicesWithSigns", "/accessors/2/componentType", 5122, "5122, which is no type of indices"},
                    Misfit{"CornersOfNoTriangle", "/accessors/2/count", 5, "5 corners, which make no whole triangles"},
                    Misfit{"Mode", "/meshes/0/primitives/0/mode", 7, "mode 7"},
                    Misfit{"MissingMaterial", "/meshes/0/primitives/0/material", 1, "materials has no element 1"},
                    Misfit{"MissingMesh", "/nodes/0/mesh", 4, "meshes has no element 4"},
                    Misfit{"MissingNode", "/scenes/0/nodes/0", 4, "nodes has no element 4"},
                    Misfit{"MissingScene", "/scene", 4, "scenes has no element 4"},
                    Misfit{"ListForAnObject", "/nodes/0", json::array(), "nodes[0] is not an object"},
                    Misfit{"ShortTranslation", "/nodes/0/translation", json::array({1, 2}),
                           "nodes[0].translation is not a list of 3 numbers"},
                    Misfit{"Version", "/asset/version", "1.0", "only glTF 2.0 is read"},
                    Misfit{"RequiredExtension", "/extensionsRequired", json::array({"KHR_draco_mesh_compression"}),
                           "KHR_draco_mesh_compression, which is not supported; export it without"}),
    [](const auto& one) { return one.param.name; });

TEST_F(GltfBuffersTest, ChunksOfAGlbAreHeldAgainstItsLength) {
  const GltfBuilder made = square();
  const std::string whole = glb(made.document, made.buffer);
  write_text(folder_ / "m.glb", whole);
  EXPECT_EQ(load_scene(folder_ / "m.glb").triangles.size(), 2U);
  const auto refused = [&](std::size_t at, std::uint32_t value) {
    std::string bytes = whole;
    std::memcpy(bytes.data() + at, &value, sizeof value);
    write_text(folder_ / "m.glb", bytes);
    return error_of([&] { load_scene(folder_ / "m.glb"); });
  };
  EXPECT_THAT(refused(4, 1), HasSubstr("says version 1"));
  EXPECT_THAT(refused(8, 2000000000), HasSubstr("announces 2000000000 bytes"));
  EXPECT_THAT(refused(12, 2123797145), HasSubstr("the chunk at byte 20 announces 2123797145 bytes"));
  EXPECT_THAT(refused(16, 0), HasSubstr("its first chunk is not JSON"));
}

}  // namespace
}  // namespace gibench::test
