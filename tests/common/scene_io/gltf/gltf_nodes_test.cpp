// Nodes of glTF scenes: instances of lights, cameras and meshes, equal names, chains and cycles.
#include <cmath>

#include "tests/common/scene_io/gltf/gltf_builder.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class GltfNodesTest : public GltfTest {};

json light_node(const char* name, double x, double y, double z, std::size_t light) {
  return {{"name", name}, {"translation", {x, y, z}}, {"extensions", {{"KHR_lights_punctual", {{"light", light}}}}}};
}

json parent_of(const std::vector<std::size_t>& children) { return {{"children", children}}; }
json mesh_node() { return {{"mesh", 0}}; }

GltfBuilder square_with(const std::vector<json>& nodes, const std::vector<std::size_t>& roots) {
  GltfBuilder made = square();
  made.document["extensions"]["KHR_lights_punctual"]["lights"] = {{{"type", "point"}, {"intensity", 2}},
                                                                  {{"type", "point"}, {"intensity", 3}}};
  made.document["cameras"] = {{{"type", "perspective"}, {"perspective", {{"yfov", 0.7}, {"znear", 0.1}}}}};
  for (const json& node : nodes) made.document["nodes"].push_back(node);
  for (const std::size_t root : roots) made.document["scenes"][0]["nodes"].push_back(root);
  return made;
}

/// Heights over the square, which lies in the plane z = 0, of all its point lights.
std::vector<double> heights(const Scene& scene) {
  std::vector<double> result;
  for (const Light& light : scene.lights) result.push_back(double{std::get<PointLight>(light).position.z} + scene.origin.z);
  return result;
}

TEST_F(GltfNodesTest, ALightOfTwoNodesIsTwoLights) {
  const Scene scene = load_document(square_with({light_node("a", 0, 0, 1, 0), light_node("b", 0, 0, 2, 0)}, {1, 2}));
  EXPECT_THAT(heights(scene), testing::ElementsAre(1.0, 2.0));
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(GltfNodesTest, LightsStandWhereTheirOwnNodesAreWhateverTheNames) {
  json outer = {{"name", "Lamp"}, {"translation", {0, 0, 1.5}}, {"children", {2}}};
  const Scene scene =
      load_document(square_with({outer, light_node("Lamp", 0, 0, 0.5, 0), light_node("Lamp", 0, 0, 4, 1)}, {1, 3}));
  EXPECT_THAT(heights(scene), testing::ElementsAre(2.0, 4.0));
  EXPECT_EQ(std::get<PointLight>(scene.lights.at(1)).intensity, Rgb(3.0F));
}

TEST_F(GltfNodesTest, ALampNamedAsAMeshIsTheLampsOwn) {
  json plate = {{"name", "Lamp"}, {"mesh", 0}, {"translation", {0, 0, -3}}};
  const Scene scene = load_document(square_with({plate, light_node("Lamp", 0, 0, 1, 0)}, {1, 2}));
  EXPECT_THAT(heights(scene), testing::ElementsAre(1.0));
  EXPECT_EQ(scene.objects.size(), 2U);
}

TEST_F(GltfNodesTest, CamerasOfTwoNodesAndOfOneName) {
  const json near = {{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 5}}};
  const json far = {{"name", "eye"}, {"camera", 0}, {"translation", {0, 0, 9}}, {"scale", {3, 3, 3}}};
  const Scene scene = load_document(square_with({near, far}, {1, 2}));
  ASSERT_EQ(scene.cameras.size(), 2U);
  EXPECT_EQ(scene.cameras[0].name, "eye");
  EXPECT_EQ(scene.cameras[1].name, "eye#2");
  EXPECT_NEAR(double{scene.cameras[1].position.z} + scene.origin.z, 9.0, 1e-6);
  EXPECT_EQ(scene.cameras[0].width, 512) << "no aspect ratio is a square";
}

TEST_F(GltfNodesTest, WhatCannotBeUsedIsNamed) {
  const json plan = {{"camera", 1}, {"name", "plan"}};
  GltfBuilder made = square_with({plan, light_node("tube", 0, 0, 1, 2), light_node("a", 0, 0, 1, 3)}, {1, 2, 3});
  made.document["cameras"].push_back({{"type", "orthographic"}, {"orthographic", json::object()}});
  made.document["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"type", "tube"}});
  made.document["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"type", "point"}, {"range", 2}});
  const Scene scene = load_document(made);
  EXPECT_TRUE(scene.cameras.empty());
  EXPECT_EQ(scene.lights.size(), 1U);
  EXPECT_THAT(scene.warnings, testing::UnorderedElementsAre(HasSubstr("perspective"), HasSubstr("\"tube\" are left out"),
                                                            HasSubstr("range is not used")));
}

TEST_F(GltfNodesTest, AMatrixIsByColumnsAndChildrenFollowTheirParents) {
  json turned = mesh_node(), above = mesh_node();
  turned["matrix"] = {0, 2, 0, 0, -2, 0, 0, 0, 0, 0, 2, 0, 5, 6, 7, 1};
  turned["children"] = {2};
  above["translation"] = {0, 0, 1};
  GltfBuilder made = square_with({turned, above}, {1});
  made.document["scenes"][0]["nodes"] = {1};
  const Scene scene = load_document(made);
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_NEAR(area_of(scene), 2 * 16.0, 1e-4);
  EXPECT_NEAR(scene.origin.x, 5.0, 1e-9);
  EXPECT_NEAR(scene.origin.y, 6.0, 1e-9);
  EXPECT_NEAR(scene.origin.z, 8.0, 1e-9) << "7 and 7 + 2";
}

TEST_F(GltfNodesTest, NodesOutsideTheSceneAreLeftOut) {
  const Scene scene = load_document(square_with({mesh_node(), light_node("a", 0, 0, 1, 0)}, {}));
  EXPECT_EQ(scene.objects.size(), 1U);
  EXPECT_TRUE(scene.lights.empty());
}

TEST_F(GltfNodesTest, WithoutScenesAllNodesAreRead) {
  json parent = parent_of({0});
  parent["translation"] = {0, 0, 3};
  GltfBuilder made = square_with({parent}, {});
  made.document.erase("scenes");
  made.document.erase("scene");
  EXPECT_NEAR(load_document(made).origin.z, 3.0, 1e-9);
}

TEST_F(GltfNodesTest, WhatSinglePrecisionCannotHoldIsRefused) {
  EXPECT_THAT(error_of_document(square_with({light_node("a", 0, 1e300, 0, 0)}, {1})), HasSubstr("nodes[1] has a transform"));
}

TEST_F(GltfNodesTest, CyclesAndSecondParentsAreRefused) {
  EXPECT_THAT(error_of_document(square_with({parent_of({2}), parent_of({1})}, {1})), HasSubstr("nodes[1] is met twice"));
  EXPECT_THAT(error_of_document(square_with({parent_of({2, 2}), mesh_node()}, {1})), HasSubstr("nodes[2] is met twice"));
  EXPECT_THAT(error_of_document(square_with({parent_of({9})}, {1})), HasSubstr("nodes has no element 9"));
}

TEST_F(GltfNodesTest, ALongChainOfNodesIsNoRecursion) {
  constexpr std::size_t length = 20000;
  std::vector<json> chain;
  for (std::size_t i = 1; i < length; ++i) {
    chain.push_back(parent_of({i + 1}));
    chain.back()["translation"] = {0, 0, 1};
  }
  chain.push_back(mesh_node());
  GltfBuilder made = square_with(chain, {});
  made.document["scenes"][0]["nodes"] = {1};
  EXPECT_NEAR(load_document(made).origin.z, length - 1.0, 1e-6);
}

}  // namespace
}  // namespace gibench::test
