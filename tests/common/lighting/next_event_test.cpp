#include "common/lighting/next_event.h"

#include <gtest/gtest.h>

#include "common/core/random.h"
#include "common/ray/ray_stream.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

Scene lit_box() {
  Scene scene = made::box_scene();
  EnvironmentLight sky;
  sky.radiance = Rgb(2.0F);
  scene.lights.push_back(sky);
  scene.lights.push_back(PointLight{Vec3(0.5F), Rgb(1.0F)});
  return scene;
}

class NextEventWeights : public testing::Test {
 protected:
  World world_{lit_box()};
  SceneLights lights_{world_, Lighting::of(world_.scene())};
  Vec3 position_{0.3F, 0.0F, 0.6F}, normal_{0.0F, 1.0F, 0.0F};
};

TEST_F(NextEventWeights, OfBothWaysToALightSumToOne) {
  RayCounts counts;
  RayStream rays(world_.rays(), counts);
  std::size_t emitters = 0, skies = 0, points = 0;
  for (const float samples : {1.0F, 4.0F}) {
    const NextEvent next_event(lights_, samples);
    for (std::uint64_t i = 0; i < 200; ++i) {
      RandomStream random(1, 2, i);
      const auto choice = static_cast<std::uint32_t>(mix_keys(7, i));
      const float u = random.next_float();
      const LightGroup group = lights_.groups()[i % lights_.groups().size()];
      const LightSample light = lights_.sample(group, position_, normal_, choice, {u, random.next_float()});
      if (!(light.pdf > 0.0F)) continue;
      if (light.delta) {
        EXPECT_EQ(next_event.weight(light, 0.3F), 1.0F);
        ++points;
        continue;
      }
      const float lobe_pdf = std::max(0.01F, light.direction.y) / pi;
      Rgb found, whole;
      if (light.at_infinity) {
        found = next_event.environment(normal_, light.direction, lobe_pdf);
        whole = next_event.environment(normal_, light.direction, 0.0F);
        ++skies;
      } else {
        const Hit hit = rays.closest_hit({position_ + 1e-4F * normal_, 0.0F, light.direction});
        ASSERT_TRUE(hit);
        const Object& object = world_.scene().objects[world_.scene().triangle_object[hit.triangle]];
        const MetEmitter met{hit.triangle, object.material, hit.distance, -glm::dot(world_.normal(hit.triangle), light.direction),
                             object.two_sided};
        found = next_event.emission(position_, normal_, met, lobe_pdf);
        whole = next_event.emission(position_, normal_, met, 0.0F);
        ++emitters;
      }
      ASSERT_GT(whole.g, 0.0F);
      EXPECT_NEAR(next_event.weight(light, lobe_pdf) + found.g / whole.g, 1.0F, 1e-3F);
    }
  }
  EXPECT_GT(emitters, 20U);
  EXPECT_GT(skies, 20U);
  EXPECT_GT(points, 20U);
}

TEST_F(NextEventWeights, BacksOfOneSidedLampsAreBlack) {
  const std::uint32_t triangle = [&] {
    for (std::uint32_t t = 0; t < world_.scene().triangles.size(); ++t)
      if (!is_black(lights_.emission_of_material(world_.scene().objects[world_.scene().triangle_object[t]].material))) return t;
    return 0U;
  }();
  const std::uint32_t material = world_.scene().objects[world_.scene().triangle_object[triangle]].material;
  const NextEvent next_event(lights_, 1.0F);
  EXPECT_TRUE(is_black(next_event.emission(position_, normal_, {triangle, material, 1.0F, -0.5F, false}, 0.3F)));
  EXPECT_FALSE(is_black(next_event.emission(position_, normal_, {triangle, material, 1.0F, -0.5F, true}, 0.3F)));
}

}  // namespace
}  // namespace gibench
