// glTF 2.0: metallic-roughness materials, emitters, punctual lights, cameras, nodes; as text and as GLB.
#include <cmath>
#include <cstring>

#include "common/image/image_file.h"
#include "tests/common/scene_io/gltf/gltf_builder.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

/// Positions of a unit square in the plane z = 0 and the indices of its two triangles.
std::string square_buffer() {
  const float positions[] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  const std::uint16_t indices[] = {0, 1, 2, 0, 2, 3};
  std::string bytes(sizeof positions + sizeof indices, '\0');
  std::memcpy(bytes.data(), positions, sizeof positions);
  std::memcpy(bytes.data() + sizeof positions, indices, sizeof indices);
  return bytes;
}

/// A square of one material, two nodes with it (one mirrored and moved), three lights and a camera.
json gltf_scene() {
  return json::parse(R"({
    "asset": {"version": "2.0"}, "extensionsUsed": ["KHR_lights_punctual", "KHR_materials_emissive_strength"],
    "extensions": {"KHR_lights_punctual": {"lights": [
      {"type": "point", "color": [1, 0.5, 0.25], "intensity": 10},
      {"type": "spot", "intensity": 5, "spot": {"innerConeAngle": 0.2, "outerConeAngle": 0.5}},
      {"type": "directional", "intensity": 3}]}},
    "scene": 0, "scenes": [{"nodes": [0, 1, 2, 3, 4, 5]}],
    "nodes": [
      {"mesh": 0, "name": "plate"},
      {"mesh": 0, "name": "image", "scale": [-1, 1, 1], "translation": [0, 0, 2]},
      {"name": "eye", "camera": 0, "translation": [0, 0, 5], "rotation": [0, 0.7071067811865476, 0, 0.7071067811865476]},
      {"name": "bulb", "extensions": {"KHR_lights_punctual": {"light": 0}}, "translation": [0, 3, 0]},
      {"name": "torch", "extensions": {"KHR_lights_punctual": {"light": 1}}, "translation": [0, 3, 1],
       "rotation": [-0.7071067811865476, 0, 0, 0.7071067811865476]},
      {"name": "sun", "extensions": {"KHR_lights_punctual": {"light": 2}}}],
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "aspectRatio": 1.5, "znear": 0.1}}],
    "materials": [{"name": "gold", "doubleSided": true, "emissiveFactor": [1, 0.5, 0],
                   "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 7}},
                   "pbrMetallicRoughness": {"baseColorFactor": [1, 0.8, 0.4, 1], "metallicFactor": 0.75, "roughnessFactor": 0.3}}],
    "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
    "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]},
                  {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
    "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
    "buffers": [{"byteLength": 60}]})");
}

class GltfSceneTest : public GltfTest {
 protected:
  Scene load_gltf() { return load_document({gltf_scene(), square_buffer()}); }
};

Vec3d in_file(const Scene& scene, const Vec3& local) { return Vec3d(local) + scene.origin; }

void expect_near(const Vec3d& actual, const Vec3d& expected) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], 1e-6) << "axis " << axis;
}

TEST_F(GltfSceneTest, MetallicRoughnessIsGgx) {
  const Scene scene = load_gltf();
  ASSERT_EQ(scene.materials.size(), 1U);
  const Material& gold = scene.materials[0];
  EXPECT_EQ(gold.name, "gold");
  EXPECT_EQ(gold.bsdf, Bsdf::ggx);
  EXPECT_FLOAT_EQ(gold.roughness, 0.3F);
  EXPECT_NEAR(gold.f0.g, 0.25F * 0.04F + 0.75F * 0.8F, 1e-6F);
  EXPECT_NEAR(gold.diffuse.g, 0.25F * 0.96F * 0.8F, 1e-6F);
  EXPECT_LE(largest(gold.diffuse + gold.f0), 1.0F);
  EXPECT_EQ(gold.emission, Rgb(7.0F, 3.5F, 0.0F));
  EXPECT_TRUE(scene.objects[0].two_sided);
  EXPECT_TRUE(scene.warnings.empty());
}

TEST_F(GltfSceneTest, NodesAreInstancesAndMirroringKeepsFronts) {
  const Scene scene = load_gltf();
  ASSERT_EQ(scene.objects.size(), 2U);
  EXPECT_EQ(scene.objects[0].name, "plate/gold");
  EXPECT_EQ(scene.objects[1].name, "image/gold");
  for (const Object& object : scene.objects) {
    const auto& [a, b, c] = scene.triangles[object.triangle_begin].corners;
    const Vec3 normal = glm::cross(scene.vertices[b] - scene.vertices[a], scene.vertices[c] - scene.vertices[a]);
    EXPECT_GT(normal.z, 0.0F) << object.name;
  }
  expect_near(scene.origin, {0.0, 0.5, 1.0});
}

TEST_F(GltfSceneTest, PunctualLights) {
  const Scene scene = load_gltf();
  ASSERT_EQ(scene.lights.size(), 3U);
  const auto& bulb = std::get<PointLight>(scene.lights[0]);
  expect_near(in_file(scene, bulb.position), {0, 3, 0});
  EXPECT_EQ(bulb.intensity, Rgb(10.0F, 5.0F, 2.5F));
  const auto& torch = std::get<SpotLight>(scene.lights[1]);
  expect_near(Vec3d(torch.direction), {0, -1, 0});
  EXPECT_NEAR(torch.cos_inner, std::cos(0.2F), 1e-6F);
  EXPECT_NEAR(torch.cos_outer, std::cos(0.5F), 1e-6F);
  const auto& sun = std::get<DirectionalLight>(scene.lights[2]);
  expect_near(Vec3d(sun.direction), {0, 0, -1});
  EXPECT_EQ(sun.irradiance, Rgb(3.0F));
}

TEST_F(GltfSceneTest, Camera) {
  const Scene scene = load_gltf();
  ASSERT_EQ(scene.cameras.size(), 1U);
  const Camera& eye = scene.cameras[0];
  EXPECT_EQ(eye.name, "eye");
  EXPECT_NEAR(eye.vertical_fov_degrees, 0.7F * 180.0F / pi, 1e-4F);
  EXPECT_EQ(eye.width, 768);
  EXPECT_EQ(eye.height, 512);
  expect_near(in_file(scene, eye.position), {0, 0, 5});
  expect_near(Vec3d(eye.look_at - eye.position), {-1, 0, 0});  // -z turned a quarter about y
}

TEST_F(GltfSceneTest, GlbIsTheSameScene) {
  const Scene text = load_gltf();
  write_text(folder_ / "m.glb", glb(gltf_scene(), square_buffer()));
  const Scene binary = load_scene(folder_ / "m.glb");
  EXPECT_EQ(binary.vertices, text.vertices);
  EXPECT_EQ(binary.lights.size(), 3U);
  EXPECT_EQ(binary.materials.at(0).emission, Rgb(7.0F, 3.5F, 0.0F));
}

TEST_F(GltfSceneTest, PictureInsideTheFileIsReplacedByItsMean) {
  write_png(folder_ / "p.png", {2, 1, {Rgb(1.0F), Rgb(0.0F, 0.5F, 0.0F)}});
  const std::string png = bytes_of(folder_ / "p.png");
  json scene = gltf_scene();
  scene["images"] = {{{"bufferView", 2}, {"mimeType", "image/png"}}};
  scene["textures"] = {{{"source", 0}}};
  scene["materials"][0]["pbrMetallicRoughness"] = {{"metallicFactor", 0}, {"baseColorTexture", {{"index", 0}}}};
  scene["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", 60}, {"byteLength", png.size()}});
  scene["buffers"][0]["byteLength"] = 60 + png.size();
  write_text(folder_ / "p.glb", glb(scene, square_buffer() + png));
  const Scene loaded = load_scene(folder_ / "p.glb");
  EXPECT_NEAR(loaded.materials.at(0).diffuse.r, 0.96F * 0.5F, 2e-3F);
  EXPECT_NEAR(loaded.materials[0].diffuse.g, 0.96F * 0.75F, 2e-3F);
  EXPECT_THAT(loaded.warnings, testing::ElementsAre(HasSubstr("replaced by its mean")));
}

TEST_F(GltfSceneTest, LightsOfAnObjectsFileAreLeftOutWithAWarning) {
  load_gltf();
  json scene = quad_scene();
  scene["objects"].push_back({{"name", "thing"}, {"file", "m.gltf"}});
  const Scene loaded = load(scene, folder_.path());
  EXPECT_TRUE(loaded.lights.empty());
  EXPECT_THAT(loaded.warnings, testing::Contains(HasSubstr("lights and cameras of its file are left out")));
  EXPECT_EQ(loaded.objects.at(1).name, "thing/gold");
  EXPECT_TRUE(loaded.objects[1].two_sided);
}

}  // namespace
}  // namespace gibench::test
