#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common/scene/light_kinds.h"
#include "common/scene/material_kinds.h"
#include "common/scene_io/native/scene_schema_text.h"

namespace gibench {
namespace {

std::vector<std::string> names_in_schema(const char* part, const char* key) {
  const auto schema = nlohmann::json::parse(scene_schema_text());
  return schema["definitions"][part]["properties"][key]["enum"].get<std::vector<std::string>>();
}

TEST(LightKinds, TheSchemaOfSceneFilesKnowsTheSameNames) {
  std::vector<std::string> names;
  for (const LightKind& kind : light_kinds()) names.emplace_back(kind.name);
  EXPECT_THAT(names_in_schema("light", "type"), testing::UnorderedElementsAreArray(names));
}

TEST(LightKinds, ALightIsMadeByTheNameOfItsKind) {
  for (std::size_t i = 0; i < light_kinds().size(); ++i) {
    const std::optional<Light> light = light_of_kind(light_kinds()[i].name);
    ASSERT_TRUE(light.has_value());
    EXPECT_EQ(light->index(), i);
    EXPECT_STREQ(kind_of(*light).name, light_kinds()[i].name);
  }
  EXPECT_FALSE(light_of_kind("laser").has_value());
}

TEST(LightKinds, ALightStandsSomewhereOrAtInfinity) {
  for (const LightKind& kind : light_kinds()) {
    const Light light = *light_of_kind(kind.name);
    EXPECT_EQ(parts_of(light).position == nullptr, kind.at_infinity) << kind.name;
    EXPECT_TRUE(kind.at_infinity || !kind.background) << kind.name;
  }
}

TEST(LightKinds, PartsAreThoseOfTheLightItself) {
  Light light = SpotLight{{1, 2, 3}, {0, -1, 0}, Rgb(5.0F), 0.9F, 0.8F};
  *parts_of(light).strength *= 2.0F;
  *parts_of(light).position = {4, 5, 6};
  const auto& spot = std::get<SpotLight>(light);
  EXPECT_EQ(spot.intensity, Rgb(10.0F));
  EXPECT_EQ(spot.position, Vec3(4, 5, 6));
  EXPECT_EQ(*parts_of(light).direction, spot.direction);
  EXPECT_EQ(parts_of(light).image, nullptr);
}

TEST(MaterialKinds, TheSchemaOfSceneFilesKnowsTheSameNames) {
  std::vector<std::string> names;
  for (const Bsdf bsdf : all_bsdfs) names.emplace_back(to_string(bsdf));
  EXPECT_THAT(names_in_schema("material", "bsdf"), testing::UnorderedElementsAreArray(names));
}

TEST(MaterialKinds, GlossAndReflectanceAreThoseOfTheKind) {
  Material material;
  material.diffuse = Rgb(0.25F);
  material.specular = Rgb(0.5F);
  material.f0 = Rgb(0.125F);
  material.reflectance = Rgb(0.75F);
  const auto as = [&](Bsdf bsdf) {
    material.bsdf = bsdf;
    return material;
  };
  EXPECT_EQ(gloss_of(as(Bsdf::diffuse)), Gloss::none);
  EXPECT_EQ(gloss_of(as(Bsdf::phong)), Gloss::lobe);
  EXPECT_EQ(gloss_of(as(Bsdf::ggx)), Gloss::lobe);
  EXPECT_EQ(gloss_of(as(Bsdf::mirror)), Gloss::mirror);
  EXPECT_EQ(largest_reflectance(as(Bsdf::diffuse)), 0.25F);
  EXPECT_EQ(largest_reflectance(as(Bsdf::phong)), 0.75F);
  EXPECT_EQ(largest_reflectance(as(Bsdf::ggx)), 1.0F);  // Schlick's term grows to what the diffuse part leaves
  EXPECT_EQ(grazing_reflectance(as(Bsdf::ggx)), Rgb(0.75F));
  EXPECT_EQ(straight_reflectance(as(Bsdf::ggx)), Rgb(0.375F));
  EXPECT_EQ(largest_reflectance(as(Bsdf::mirror)), 0.75F);
  material.specular = material.reflectance = Rgb();
  EXPECT_EQ(gloss_of(as(Bsdf::phong)), Gloss::none);
  EXPECT_EQ(gloss_of(as(Bsdf::mirror)), Gloss::none);
}

}  // namespace
}  // namespace gibench
