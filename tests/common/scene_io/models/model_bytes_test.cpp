// The way of a model from one process to another.
#include "common/scene_io/models/model_bytes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/core/error.h"

namespace gibench {
namespace {

/// Every member differs from its default, and every kind of light that a model may hold is there.
Model full_model() {
  Model model;
  ModelPart& part = model.parts.emplace_back();
  part.name = std::string("a\0b", 3);
  part.material = 1;
  part.geometry.vertices = {{0.1, -0.0, 1e300}, {1, 2, 3}, {std::nan(""), 5, 6}, {7, 8, 9}};
  part.geometry.faces = {{{0, 1, 2, 2}}, {{3, 2, 1, 0}}};
  model.parts.emplace_back().name = "empty";
  model.materials.resize(2);
  model.materials[1] = {{"gold", Bsdf::ggx, Rgb(0.1F, 0.2F, 0.3F), Rgb(0.4F), 5.0F, 0.6F, Rgb(0.7F), Rgb(0.8F), Rgb(9.0F)}, true};
  model.lights = {{PointLight{{1, 2, 3}, Rgb(4.0F)}, {5, 6, 7}},
                  {SpotLight{{1, 2, 3}, {0, 0, 1}, Rgb(4.0F), 0.9F, 0.8F}, {5, 6, 7}},
                  {DirectionalLight{{0, 1, 0}, Rgb(2.0F)}, {8, 9, 10}},
                  {EnvironmentLight{Rgb(3.0F), nullptr, 45.0F}, {}}};
  model.cameras = {{{"main", {1, 2, 3}, {4, 5, 6}, {0, 1, 0}, 50.0F, 640, 480}, {7, 8, 9}, {10, 11, 12}}};
  model.warnings = {"one", "", "three"};
  return model;
}

TEST(ModelBytes, GiveTheModelBack) {
  const Model before = full_model(), after = model_of_bytes(bytes_of(before));
  ASSERT_EQ(after.parts.size(), 2U);
  EXPECT_EQ(after.parts[0].name, before.parts[0].name);
  EXPECT_EQ(after.parts[0].material, 1U);
  ASSERT_EQ(after.parts[0].geometry.vertices.size(), 4U);
  EXPECT_EQ(after.parts[0].geometry.vertices[0], before.parts[0].geometry.vertices[0]);
  EXPECT_TRUE(std::signbit(after.parts[0].geometry.vertices[0].y));
  EXPECT_TRUE(std::isnan(after.parts[0].geometry.vertices[2].x));
  EXPECT_EQ(after.parts[0].geometry.faces[1].corners, before.parts[0].geometry.faces[1].corners);
  EXPECT_EQ(after.materials[1].material.name, "gold");
  EXPECT_EQ(after.materials[1].material.bsdf, Bsdf::ggx);
  EXPECT_EQ(after.materials[1].material.emission, Rgb(9.0F));
  EXPECT_TRUE(after.materials[1].two_sided);
  EXPECT_FALSE(after.materials[0].two_sided);
  ASSERT_EQ(after.lights.size(), 4U);
  EXPECT_EQ(std::get<SpotLight>(after.lights[1].light).cos_outer, 0.8F);
  EXPECT_EQ(std::get<EnvironmentLight>(after.lights[3].light).rotate_y_degrees, 45.0F);
  EXPECT_EQ(after.lights[2].position, Vec3d(8, 9, 10));
  EXPECT_EQ(after.cameras[0].camera.height, 480);
  EXPECT_EQ(after.cameras[0].look_at, Vec3d(10, 11, 12));
  EXPECT_EQ(after.warnings, before.warnings);
  EXPECT_EQ(bytes_of(after), bytes_of(before)) << "what is not looked at above";
}

TEST(ModelBytes, CutAnywhereAreNoModel) {
  const std::string bytes = bytes_of(full_model());
  for (std::size_t length = 0; length < bytes.size(); ++length)
    EXPECT_THROW(model_of_bytes(std::string_view(bytes).substr(0, length)), WorkError) << length;
  EXPECT_THROW(model_of_bytes(bytes + "x"), WorkError);
}

TEST(ModelBytes, OfAProcessThatWentWrongAreChecked) {
  Model model = full_model();
  model.parts[0].geometry.faces[1].corners[0] = 4;
  EXPECT_THROW(model_of_bytes(bytes_of(model)), WorkError) << "a corner past the end";
  model = full_model();
  model.parts[0].material = 2;
  EXPECT_THROW(model_of_bytes(bytes_of(model)), WorkError) << "a material past the end";
  model = full_model();
  model.materials[0].material.bsdf = static_cast<Bsdf>(4);
  EXPECT_THROW(model_of_bytes(bytes_of(model)), WorkError) << "no kind of BRDF";
  const std::string endless(8, '\xff');
  EXPECT_THROW(model_of_bytes(endless), WorkError) << "more parts than bytes";
}

}  // namespace
}  // namespace gibench
