// What a valid scene file becomes in memory.
#include <cmath>
#include <set>

#include "tests/common/scene_io/scene_text.h"

namespace gibench::test {
namespace {

using nlohmann::json;
using testing::ElementsAre;

constexpr float tolerance = 1e-6F;

void expect_near(const Vec3d& actual, const Vec3d& expected, double within = 1e-6) {
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(actual[axis], expected[axis], within) << "axis " << axis;
}

/// A vertex in file coordinates.
Vec3d vertex(const Scene& scene, std::size_t index) { return Vec3d(scene.vertices[index]) + scene.origin; }

/// One triangle (1,0,0), (0,1,0), (0,0,1) with the keys of a transform.
Scene load_transformed(const json& transform) {
  json scene = quad_scene();
  scene["objects"][0]["vertices"] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  scene["objects"][0]["faces"] = {{0, 1, 2}};
  scene["objects"][0].update(transform);
  return load(scene);
}

Vec3d normal_of_first_triangle(const Scene& scene) {
  const auto& [a, b, c] = scene.triangles.at(0).corners;
  return glm::normalize(glm::cross(Vec3d(scene.vertices[b] - scene.vertices[a]), Vec3d(scene.vertices[c] - scene.vertices[a])));
}

TEST(SceneFile, QuadsAndTrianglesAreKept) {
  json text = quad_scene();
  text["objects"][0]["faces"] = {{0, 1, 2, 3}, {0, 1, 2}, {0, 0, 1, 2}};
  const Scene scene = load(text);
  ASSERT_EQ(scene.faces.size(), 3U);
  EXPECT_TRUE(scene.faces[0].is_quad());
  EXPECT_FALSE(scene.faces[1].is_quad());
  EXPECT_TRUE(scene.faces[2].is_quad());  // a repeated corner is not an error
  EXPECT_THAT(scene.faces[0].corners, ElementsAre(0, 1, 2, 3));
  EXPECT_THAT(scene.faces[1].corners, ElementsAre(0, 1, 2, 2));
  EXPECT_EQ(scene.triangles.size(), 5U);
  EXPECT_EQ(scene.name, "quad");
}

TEST(SceneFile, LargePolygonsBecomeTriangles) {
  json text = quad_scene();
  // An L of six corners, area 3, and the quad of its lower arm.
  text["objects"][0]["vertices"] = {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}};
  text["objects"][0]["faces"] = {{0, 1, 2, 3, 4, 5}, {0, 1, 2, 3}};
  const Scene scene = load(text);
  ASSERT_EQ(scene.faces.size(), 5U);
  EXPECT_TRUE(scene.faces[4].is_quad());
  float area = 0.0F;
  for (std::size_t f = 0; f < 4; ++f) {
    const auto& c = scene.faces[f].corners;
    const Vec3 cross = glm::cross(scene.vertices[c[1]] - scene.vertices[c[0]], scene.vertices[c[2]] - scene.vertices[c[0]]);
    EXPECT_GT(cross.z, 0.0F);
    area += 0.5F * cross.z;
  }
  EXPECT_NEAR(area, 3.0F, 1e-6F);
}

TEST(SceneFile, ScaleRotateTranslateInThatOrder) {
  expect_near(vertex(load_transformed({{"scale", 2}}), 1), {0, 2, 0});
  expect_near(vertex(load_transformed({{"scale", {2, 3, 4}}}), 2), {0, 0, 4});
  expect_near(vertex(load_transformed({{"rotate_degrees", {90, 0, 0}}}), 1), {0, 0, 1});   // y → z
  expect_near(vertex(load_transformed({{"rotate_degrees", {0, 90, 0}}}), 2), {1, 0, 0});   // z → x
  expect_near(vertex(load_transformed({{"rotate_degrees", {0, 0, 90}}}), 0), {0, 1, 0});   // x → y
  expect_near(vertex(load_transformed({{"rotate_degrees", {90, 90, 0}}}), 1), {1, 0, 0});  // y → z → x
  const double c = std::cos(pi_double / 6), s = std::sin(pi_double / 6);
  expect_near(vertex(load_transformed({{"rotate_degrees", {0, 0, 30}}}), 0), {c, s, 0});
  expect_near(vertex(load_transformed({{"scale", {2, 1, 1}}, {"rotate_degrees", {0, 0, 90}}, {"translate", {10, 20, 30}}}), 0),
              {10, 22, 30});
}

TEST(SceneFile, RightAnglesAreExact) {
  const Scene scene = load_transformed({{"rotate_degrees", {90, -180, 270}}});
  std::set<float> coordinates;
  for (const Vec3& v : scene.vertices)
    for (int axis = 0; axis < 3; ++axis) coordinates.insert(v[axis]);
  EXPECT_EQ(coordinates, (std::set<float>{-0.5F, 0.5F}));
}

TEST(SceneFile, MirroringKeepsFrontsInFront) {
  const double third = 1.0 / std::sqrt(3.0);
  expect_near(normal_of_first_triangle(load_transformed(json::object())), {third, third, third});
  // A mirror image of the triangle, seen from the mirrored side, still shows its front.
  expect_near(normal_of_first_triangle(load_transformed({{"scale", {-1, 1, 1}}})), {-third, third, third});
  expect_near(normal_of_first_triangle(load_transformed({{"scale", -1}})), {-third, -third, -third});
  expect_near(normal_of_first_triangle(load_transformed({{"scale", {-1, -1, 1}}})), {-third, -third, third});
  json quad = quad_scene();
  quad["objects"][0]["scale"] = {1, 1, -1};
  const Scene mirrored = load(quad);
  ASSERT_TRUE(mirrored.faces[0].is_quad());
  expect_near(normal_of_first_triangle(mirrored), {0, 0, -1});
}

TEST(SceneFile, FarFromTheOriginNothingChanges) {
  json near = full_scene();
  near["objects"][0].erase("rotate_degrees");
  near["objects"][0]["vertices"] = {{0.123456789, 0.2, 0.3}, {0.987654321, 0.1, 0.33}, {0.5, 0.777777, 0.2}, {0.1, 0.7, 0.9}};
  json far = near;
  const Vec3d shift(1e5, -1e5, 2e5);
  const auto move = [&](json& point) {
    for (int axis = 0; axis < 3; ++axis)
      point[static_cast<std::size_t>(axis)] = point[static_cast<std::size_t>(axis)].get<double>() + shift[axis];
  };
  for (json& v : far["objects"][0]["vertices"]) {
    v[0] = v[0].get<double>() + shift.x;
    v[1] = v[1].get<double>() + shift.y / 2.0;  // the object's scale doubles y
    v[2] = v[2].get<double>() + shift.z;
  }
  for (const std::size_t light : {0U, 1U}) move(far["lights"][light]["position"]);
  for (json& camera : far["cameras"]) move(camera["position"]), move(camera["look_at"]);
  far["edits"].erase(5);
  near["edits"].erase(5);

  const Scene a = load(near), b = load(far);
  expect_near(b.origin - a.origin, shift, 1e-9);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t i = 0; i < a.vertices.size(); ++i) expect_near(a.vertices[i], b.vertices[i], 2e-7);
  expect_near(std::get<PointLight>(a.lights[0]).position, std::get<PointLight>(b.lights[0]).position, 2e-6);
  expect_near(std::get<SpotLight>(a.lights[1]).position, std::get<SpotLight>(b.lights[1]).position, 2e-6);
  expect_near(a.cameras[0].position, b.cameras[0].position, 2e-6);
  expect_near(a.cameras[0].look_at, b.cameras[0].look_at, 2e-6);
}

TEST(SceneFile, OriginIsTheCentreOfTheBox) {
  json text = quad_scene();
  text["objects"][0]["vertices"].push_back({100, 100, 100});  // no face has it
  const Scene scene = load(text);
  expect_near(scene.origin, {0.5, 0.5, 0.0}, 0.0);
  EXPECT_EQ(scene.vertices.size(), 4U);
  EXPECT_THAT(scene.warnings, ElementsAre(testing::HasSubstr("1 vertices belong to no face")));
}

TEST(SceneFile, MaterialsOfEveryKind) {
  const Scene scene = load(full_scene());
  const auto material = [&](const std::string& name) {
    for (const Material& m : scene.materials)
      if (m.name == name) return m;
    throw std::out_of_range(name);
  };
  EXPECT_EQ(material("white").bsdf, Bsdf::diffuse);
  EXPECT_EQ(material("white").diffuse, Rgb(0.5F));
  EXPECT_EQ(material("lamp").diffuse, Rgb(0.0F, 0.1F, 0.2F));
  EXPECT_EQ(material("lamp").emission, Rgb(18.4F, 15.6F, 8.0F));
  EXPECT_EQ(material("satin").bsdf, Bsdf::phong);
  EXPECT_EQ(material("satin").specular, Rgb(0.4F));
  EXPECT_EQ(material("satin").exponent, 20.0F);
  EXPECT_EQ(material("metal").bsdf, Bsdf::ggx);
  EXPECT_EQ(material("metal").roughness, 0.3F);
  EXPECT_EQ(material("metal").f0, Rgb(0.9F, 0.6F, 0.3F));
  EXPECT_EQ(material("metal").diffuse, Rgb(0.05F));
  EXPECT_EQ(material("glass").bsdf, Bsdf::mirror);
  EXPECT_EQ(material("glass").reflectance, Rgb(1.0F, 0.9F, 0.8F));
  EXPECT_EQ(scene.material_of_object(0).name, "white");
  EXPECT_TRUE(scene.objects[0].two_sided);
  EXPECT_EQ(scene.objects[0].group, "ground");
}

TEST(SceneFile, LightsOfEveryKind) {
  const Scene scene = load(full_scene());
  ASSERT_EQ(scene.lights.size(), 4U);
  EXPECT_EQ(std::get<PointLight>(scene.lights[0]).intensity, Rgb(1, 2, 3));
  expect_near(Vec3d(std::get<PointLight>(scene.lights[0]).position) + scene.origin, {0.5, 0.9, 0.5});
  const auto& spot = std::get<SpotLight>(scene.lights[1]);
  EXPECT_EQ(spot.direction, Vec3(0, -1, 0));
  EXPECT_NEAR(spot.cos_inner, std::cos(pi / 9), tolerance);
  EXPECT_NEAR(spot.cos_outer, std::cos(pi / 6), tolerance);
  EXPECT_EQ(std::get<DirectionalLight>(scene.lights[2]).irradiance, Rgb(1.0F));
  const auto& sky = std::get<EnvironmentLight>(scene.lights[3]);
  EXPECT_EQ(sky.radiance, Rgb(1, 2, 1));
  EXPECT_EQ(sky.image, nullptr);
}

TEST(SceneFile, DirectionsOfAnyLength) {
  json text = full_scene();
  for (const double length : {1e-300, 1e300}) {
    text["lights"][2]["direction"] = {0, -length, 0};
    const Scene scene = load(text);
    EXPECT_EQ(std::get<DirectionalLight>(scene.lights[2]).direction, Vec3(0, -1, 0)) << length;
  }
}

TEST(SceneFile, CamerasWithDefaults) {
  const Scene scene = load(full_scene());
  ASSERT_EQ(scene.cameras.size(), 2U);
  EXPECT_EQ(scene.cameras[0].name, "front");
  EXPECT_EQ(scene.cameras[0].width, 64);
  EXPECT_EQ(scene.cameras[0].height, 32);
  EXPECT_EQ(scene.cameras[1].name, "camera-2");
  EXPECT_EQ(scene.cameras[1].width, 512);
  EXPECT_EQ(scene.cameras[1].vertical_fov_degrees, 40.0F);
  EXPECT_EQ(scene.cameras[1].up, Vec3(0, 1, 0));
}

TEST(SceneFile, EditsBuildOnOneAnother) {
  json text = full_scene();
  text["edits"].push_back({{"material", "metal"}, {"diffuse", 0.4}});
  text["edits"].push_back({{"material", "white"}, {"bsdf", "mirror"}, {"reflectance", 0.7}});
  text["edits"].push_back({{"light", 0}, {"intensity", 7}});
  const Scene scene = load(text);
  const auto edit = [&](std::size_t i) -> const SceneEdit& { return scene.edits.at(i); };
  EXPECT_EQ(std::get<MoveEdit>(edit(0)).object, "floor");
  EXPECT_EQ(std::get<MoveEdit>(edit(0)).translate, Vec3d(0.1, 0, 0));
  EXPECT_EQ(std::get<MoveEdit>(edit(0)).rotate_degrees, Vec3d(0, 10, 0));
  EXPECT_EQ(std::get<MaterialEdit>(edit(1)).after.diffuse, Rgb(0.2F, 0.2F, 0.7F));
  EXPECT_EQ(std::get<MaterialEdit>(edit(3)).after.f0, Rgb(0.5F));
  EXPECT_EQ(std::get<MaterialEdit>(edit(3)).after.diffuse, Rgb(0.05F));
  const Material& metal = std::get<MaterialEdit>(edit(9)).after;
  EXPECT_EQ(metal.diffuse, Rgb(0.4F));
  EXPECT_EQ(metal.f0, Rgb(0.5F));  // from edit 3
  EXPECT_EQ(metal.roughness, 0.1F);
  const Material& mirror = std::get<MaterialEdit>(edit(10)).after;
  EXPECT_EQ(mirror.bsdf, Bsdf::mirror);
  EXPECT_EQ(mirror.diffuse, Rgb(0.0F));
  EXPECT_EQ(mirror.name, "white");
  const auto& moved = std::get<PointLight>(std::get<LightEdit>(edit(11)).after);
  EXPECT_EQ(moved.intensity, Rgb(7.0F));
  expect_near(Vec3d(moved.position) + scene.origin, {0.2, 0.9, 0.5});  // from edit 5
  EXPECT_EQ(scene.materials.size(), 5U);
  EXPECT_EQ(std::get<PointLight>(scene.lights[0]).intensity, Rgb(1, 2, 3));  // the scene itself is before all edits
}

TEST(SceneFile, ExposureAndName) {
  const Scene scene = load(full_scene());
  ASSERT_TRUE(scene.exposure.has_value());
  EXPECT_EQ(scene.exposure->value, 1.5F);
  EXPECT_EQ(scene.exposure->start, -3.0F);
  EXPECT_EQ(scene.exposure->stop, 2.0F);
  json unnamed = quad_scene();
  unnamed.erase("name");
  EXPECT_EQ(parse_scene(unnamed.dump(), "rooms/hall.scene.json").name, "hall");
  EXPECT_FALSE(load(unnamed).exposure.has_value());
}

}  // namespace
}  // namespace gibench::test
