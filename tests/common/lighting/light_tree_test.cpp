// Lights drawn by what they give at a point.
#include "common/lighting/light_tree.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/core/random.h"
#include "common/lighting/scene_lights.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

using made::SceneBuilder;

constexpr std::uint32_t steps = 1U << 16;  // of a fraction of one

std::vector<PlacedLight> strewn_lights(std::size_t count) {
  std::vector<PlacedLight> lights;
  for (std::size_t i = 0; i < count; ++i) {
    RandomStream random(1, 2, i);
    const auto coordinate = [&] { return 10.0F * random.next_float() - 5.0F; };
    const Vec3 centre{coordinate(), coordinate(), coordinate() + 6.0F}, toward{coordinate(), coordinate(), -5.0F};
    lights.push_back({centre, random.next_float(), i % 3 == 0 ? Vec3(0.0F) : toward, i % 3 == 1 ? 0.0F : random.next_float()});
  }
  return lights;
}

TEST(LightTree, DrawsEveryLightWithItsProbability) {
  for (const std::size_t count : {2U, 8U, 9U, 100U}) {
    const LightTree tree(strewn_lights(count));
    for (const Vec3& position : {Vec3(0.0F, 0.0F, -4.0F), Vec3(3.0F, -2.0F, 5.0F), Vec3(200.0F, 0.0F, -300.0F)}) {
      const Vec3 normal = glm::normalize(Vec3(0.1F, 0.2F, 1.0F));
      std::vector<double> drawn(count), told(count);
      double nothing = 0.0;
      for (std::uint32_t i = 0; i < steps; ++i) {
        const LightTree::Choice choice = tree.choose(position, normal, (i + 0.5) / steps);
        if (!(choice.probability > 0.0F)) {
          nothing += 1.0 / steps;
          continue;
        }
        drawn[choice.light] += 1.0 / steps;
        told[choice.light] = static_cast<double>(choice.probability);
      }
      double sum = nothing;
      for (std::size_t light = 0; light < count; ++light) {
        const auto probability = static_cast<double>(tree.probability(light, position, normal));
        EXPECT_NEAR(drawn[light], probability, 2.0 / steps) << light << " of " << count;
        if (drawn[light] > 0.0) {
          EXPECT_NEAR(told[light], probability, 1e-5 * probability);
        }
        sum += probability;
      }
      EXPECT_NEAR(sum, 1.0, 16.0 / steps) << "where nothing is found is cut into steps";
    }
  }
}

TEST(LightTree, IsEmptyWithoutLightsAndFindsNoneBehindTheSurface) {
  EXPECT_EQ(LightTree().choose(Vec3(0.0F), {0, 0, 1}, 0.5).probability, 0.0F);
  const LightTree tree(strewn_lights(20));
  EXPECT_EQ(tree.choose({0.0F, 0.0F, 100.0F}, {0, 0, 1}, 0.5).probability, 0.0F);
}

/// A floor at z = 0 under these lights, and the middle of it.
struct Floor {
  World world;
  SceneLights lights;
  Vec3 position{0.0F}, normal{0.0F, 0.0F, 1.0F};

  explicit Floor(const std::vector<Light>& all) : world(scene(all), 1), lights(world, Lighting::of(world.scene())) {}
  static Scene scene(const std::vector<Light>& all) {
    SceneBuilder builder;
    builder.quad("floor", builder.diffuse("white", Rgb(0.5F)), {{{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}}});
    for (const Light& light : all) builder.light(light);
    return builder.build("floor");
  }
  /// Mean and mean square of the irradiance that one punctual light sample stands for, over evenly spaced choices.
  std::pair<double, double> moments(LightGroup group) const {
    double mean = 0.0, square = 0.0;
    for (std::uint32_t i = 0; i < steps; ++i) {
      const LightSample light = lights.sample(group, position, normal, i << 16U, {0.5F, 0.5F});
      if (!(light.pdf > 0.0F)) continue;
      const double estimate = static_cast<double>(light.radiance.g) * std::fmax(0.0, static_cast<double>(light.direction.z)) /
                              static_cast<double>(light.pdf);
      mean += estimate / steps, square += estimate * estimate / steps;
    }
    return {mean, square};
  }
};

TEST(SceneLights, OfManyLampsTheNearOnesAreDrawn) {
  std::vector<Light> row;
  double truth = 0.0, squares = 0.0;
  constexpr int count = 200;
  for (int i = 0; i < count; ++i) {
    const double x = 0.1 * (i - 99.5);
    row.emplace_back(PointLight{{static_cast<float>(x), 0.0F, 0.5F}, Rgb(1.0F)});
    const double irradiance = 0.5 / std::pow(x * x + 0.25, 1.5);
    truth += irradiance, squares += irradiance * irradiance;
  }
  const auto [mean, square] = Floor(row).moments(LightGroup::placed);
  EXPECT_NEAR(mean, truth, 1e-3 * truth);
  // By power each has probability 1 / count, and the mean square is count · Σ irradiance², 12 times the squared mean. Half of
  // the draws follow the irradiance itself, which makes it twice the squared mean at most; the nodes' estimates of clusters
  // are allowed another half of that.
  EXPECT_GT(count * squares, 10.0 * truth * truth);
  EXPECT_LT(square, 3.0 * truth * truth);
}

TEST(SceneLights, OfSeveralSunsThoseThatTheSurfaceFacesAreDrawn) {
  const auto sun = [](float slant, float irradiance) {
    return DirectionalLight{glm::normalize(Vec3(slant, 0.0F, -1.0F)), Rgb(irradiance)};
  };
  DirectionalLight below;
  below.direction = {0.0F, 0.0F, 1.0F};
  below.irradiance = Rgb(100.0F);
  const Floor floor({sun(0.0F, 5.0F), below, sun(1.0F, 1.0F), sun(-2.0F, 0.1F)});
  const auto [mean, square] = floor.moments(LightGroup::directional);
  const double truth = 5.0 + 1.0 / std::sqrt(2.0) + 0.1 / std::sqrt(5.0);
  EXPECT_NEAR(mean, truth, 1e-3 * truth);
  EXPECT_LT(square, 2.0 * truth * truth) << "half of the draws follow the irradiance";
}

TEST(SceneLights, EachGroupHasASampleOfItsOwn) {
  const Floor floor(
      {PointLight{{0.0F, 0.0F, 1.0F}, Rgb(1.0F)}, DirectionalLight{{0.0F, 0.0F, -1.0F}, Rgb(1e6F)}, EnvironmentLight()});
  ASSERT_EQ(floor.lights.groups().size(), 3U);
  for (const LightGroup group : floor.lights.groups()) {
    EXPECT_FALSE(floor.lights.has_choice(group));
    const LightSample light = floor.lights.sample(group, floor.position, floor.normal, 0U, {0.3F, 0.6F});
    EXPECT_EQ(light.delta, group != LightGroup::environment);
    if (light.delta) {
      EXPECT_EQ(light.pdf, 1.0F) << "nothing is chosen";
    }
  }
}

/// Mean and variance of the irradiance under a lamp of two triangles, from 64 points of a sequence each.
template <class SampleOf>
std::pair<double, double> under_a_lamp(const SampleOf& sample_of) {
  constexpr int estimates = 400;
  double sum = 0.0, squares = 0.0;
  for (std::uint64_t key = 0; key < estimates; ++key) {
    double irradiance = 0.0;
    for (std::uint32_t i = 0; i < 64; ++i) {
      const LightSample light = sample_of(SobolSequence(mix_keys(31, key)), i);
      if (light.pdf > 0.0F)
        irradiance += static_cast<double>(light.radiance.g * std::fmax(0.0F, light.direction.y) / light.pdf) / 64.0;
    }
    sum += irradiance / estimates, squares += irradiance * irradiance / estimates;
  }
  return {sum, squares - sum * sum};
}

TEST(SceneLights, OnePairForLampAndPlaceIsEvenOnEveryLamp) {
  const World world(made::box_scene(), 1);
  const SceneLights lights(world, Lighting::of(world.scene()));
  ASSERT_TRUE(lights.has_choice(LightGroup::placed));
  const Vec3 position{0.3F, 0.0F, 0.6F}, normal{0.0F, 1.0F, 0.0F};
  const auto [by_one, variance_by_one] = under_a_lamp([&](const SobolSequence& sequence, std::uint32_t i) {
    return lights.sample(LightGroup::placed, position, normal, sequence.pair(i, 0));
  });
  const auto [by_two, variance_by_two] = under_a_lamp([&](const SobolSequence& sequence, std::uint32_t i) {
    return lights.sample(LightGroup::placed, position, normal, sequence.pair(i, 1).x, sequence.pair(i, 0).unit());
  });
  EXPECT_NEAR(by_one, by_two, 4.0 * std::sqrt((variance_by_one + variance_by_two) / 400.0));
  EXPECT_LT(variance_by_one, 0.5 * variance_by_two);
}

}  // namespace
}  // namespace gibench
