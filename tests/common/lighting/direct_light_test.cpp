// The shared evaluator against closed forms.
#include "common/lighting/direct_light.h"

#include <gtest/gtest.h>

#include <cmath>

#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"
#include "common/lighting/light_choice.h"
#include "common/lighting/punctual_lights.h"
#include "common/lighting/scene_lights.h"
#include "common/scene/made_scenes.h"
#include "tests/support/counting_rays.h"

namespace gibench {
namespace {

using made::SceneBuilder;

/// A unit square about the origin in the plane z = 0 that looks up, and what is above it.
struct Plate {
  SceneBuilder builder;
  std::uint32_t white = builder.diffuse("white", Rgb(0.5F));

  Plate() { builder.quad("plate", white, {{{-0.5F, -0.5F, 0}, {0.5F, -0.5F, 0}, {0.5F, 0.5F, 0}, {-0.5F, 0.5F, 0}}}); }
  /// A square lamp of this half edge at this height, looking down.
  Plate& lamp(float height, float half, float radiance, bool two_sided = false) {
    builder.quad("lamp", builder.diffuse("lamp", Rgb(), Rgb(radiance)),
                 {{{-half, -half, height}, {-half, half, height}, {half, half, height}, {half, -half, height}}}, two_sided);
    return *this;
  }
};

struct Lit {
  World world;
  DirectLight light;
  RayCounts counts;

  explicit Lit(const Scene& scene) : world(scene, 1), light(world, Lighting::of(world.scene())) {}
  SurfaceSample centre() { return world.sample_at(0, {0.0F, 0.5F}, {0.0F, 0.0F, 1.0F}); }
  /// Mean of independent estimates.
  double irradiance(const SurfaceSample& sample, int samples, int estimates) {
    RayStream rays(world.rays(), counts);
    double sum = 0.0;
    for (int i = 0; i < estimates; ++i)
      sum += static_cast<double>(light.irradiance(sample, static_cast<std::uint64_t>(i), samples, rays).r);
    return sum / estimates;
  }
};

/// Irradiance under the middle of a square of half edge a at height h and radiance 1: four corners (Howell B-3).
double under_square(double a, double h) {
  const double s = a / std::sqrt(a * a + h * h);
  return 4.0 * s * std::atan(s);
}

TEST(DirectLight, AreaLampsNearAndFarMatchTheClosedForm) {
  for (const float height : {0.01F, 0.3F, 1.0F, 20.0F}) {
    Lit lit(Plate().lamp(height, 0.5F, 2.0F).builder.build("lamp"));
    const double truth = 2.0 * under_square(0.5, static_cast<double>(height));
    EXPECT_NEAR(lit.irradiance(lit.centre(), 64, 128), truth, 3e-3 * truth) << height;
  }
}

TEST(DirectLight, FewerHemisphereSamplesExpectTheSameForFewerRays) {
  for (const float height : {0.01F, 0.3F, 1.0F}) {
    Lit lit(Plate().lamp(height, 0.5F, 2.0F).builder.build("lamp"));
    const double truth = 2.0 * under_square(0.5, static_cast<double>(height));
    constexpr std::size_t count = 8192;
    const std::vector<SurfaceSample> points(count, lit.centre());
    std::vector<std::uint64_t> keys(count);
    for (std::size_t i = 0; i < count; ++i) keys[i] = i;
    std::vector<Rgb> light(count);
    {
      RayStream rays(lit.world.rays(), lit.counts);
      lit.light.irradiance(points, keys, 1, rays, light, {.hemisphere_share = 0.25F});
    }
    double sum = 0.0, squares = 0.0;
    for (const Rgb& value : light) {
      sum += static_cast<double>(value.r);
      squares += static_cast<double>(value.r * value.r);
    }
    const double mean = sum / count, standard_error = std::sqrt((squares / count - mean * mean) / count);
    EXPECT_NEAR(mean, truth, 4.0 * standard_error) << height;
    EXPECT_LT(standard_error, 0.03 * truth);
    // A quarter of the points, to within four standard deviations of a draw.
    EXPECT_NEAR(static_cast<double>(lit.counts.closest_hit), 0.25 * count, 4.0 * std::sqrt(count * 0.25 * 0.75));
  }
}

TEST(DirectLight, SmallLightIsTriedByChanceAndExpectsTheSame) {
  Plate plate;
  plate.builder.light(PointLight{{0.0F, 0.0F, 2.0F}, Rgb(4.0F)});  // 1 W/m²
  Lit lit(plate.builder.build("point"));
  constexpr std::size_t count = 4096;
  const std::vector<SurfaceSample> points(count, lit.centre());
  std::vector<std::uint64_t> keys(count);
  for (std::size_t i = 0; i < count; ++i) keys[i] = i;
  std::vector<Rgb> light(count);
  for (const float small : {0.5F, 5.0F}) {
    const std::uint64_t before = lit.counts.occlusion;
    {
      RayStream rays(lit.world.rays(), lit.counts);
      lit.light.irradiance(points, keys, 1, rays, light, {.small_light = small});
    }
    const auto tried = static_cast<double>(lit.counts.occlusion - before);
    if (small < 1.0F) {
      EXPECT_EQ(tried, count);
      for (const Rgb& value : light) EXPECT_FLOAT_EQ(value.r, 1.0F);
      continue;
    }
    // One in five, to within four standard deviations of a draw; each brings 5 W/m².
    EXPECT_NEAR(tried, 0.2 * count, 4.0 * std::sqrt(count * 0.2 * 0.8));
    double sum = 0.0;
    for (const Rgb& value : light) sum += static_cast<double>(value.r);
    EXPECT_NEAR(sum, 5.0 * tried, 1e-3 * tried);
  }
}

TEST(DirectLight, AConstantSkyIsExactWhereNothingHidesIt) {
  Plate plate;
  EnvironmentLight sky;
  sky.radiance = Rgb(2.0F, 1.0F, 0.5F);
  plate.builder.light(sky);
  Lit lit(plate.builder.build("sky"));
  RayStream rays(lit.world.rays(), lit.counts);
  const Rgb irradiance = lit.light.irradiance(lit.centre(), 7, 4, rays);
  EXPECT_NEAR(irradiance.r, 2.0F * pi, 1e-4F);
  EXPECT_NEAR(irradiance.b, 0.5F * pi, 1e-4F);
  EXPECT_EQ(lit.light.environment({0.0F, 0.0F, 1.0F}), sky.radiance);
}

TEST(DirectLight, TwoEnvironmentsAdd) {
  Plate plate;
  EnvironmentLight sky, image;
  image.image = std::make_shared<EnvironmentImage>(EnvironmentImage{2, 2, std::vector<Rgb>(4, Rgb(3.0F))});
  plate.builder.light(sky);
  plate.builder.light(image);
  Lit lit(plate.builder.build("skies"));
  EXPECT_NEAR(lit.irradiance(lit.centre(), 64, 4096), 4.0 * pi_double, 0.02);
}

TEST(DirectLight, PunctualLightsAreExact) {
  Plate plate;
  plate.builder.light(PointLight{{0.3F, 0.0F, 2.0F}, Rgb(5.0F)});
  plate.builder.light(DirectionalLight{glm::normalize(Vec3(1.0F, 0.0F, -1.0F)), Rgb(0.7F)});
  SpotLight spot{{0.0F, 0.0F, 1.5F}, {0.0F, 0.0F, -1.0F}, Rgb(2.0F), std::cos(0.3F), std::cos(0.5F)};
  plate.builder.light(spot);
  Lit lit(plate.builder.build("punctual"));
  const double squared = 0.3 * 0.3 + 4.0;
  const double truth = 5.0 * 2.0 / std::pow(squared, 1.5) + 0.7 / std::sqrt(2.0) + 2.0 / 2.25;
  EXPECT_NEAR(lit.irradiance(lit.centre(), 1, 1), truth, 1e-5 * truth);
  EXPECT_EQ(lit.counts.closest_hit.load(), 0U) << "nothing that a ray could meet";
  EXPECT_EQ(lit.counts.occlusion.load(), 3U) << "one for each light";
}

TEST(DirectLight, ManyPunctualLightsAreSampledWithoutBias) {
  Plate plate;
  double truth = 0.0;
  for (int i = 0; i < 100; ++i) {
    const double x = 0.02 * i - 1.0;
    plate.builder.light(PointLight{{static_cast<float>(x), 0.3F, 1.0F}, Rgb(0.1F)});
    truth += 0.1 / std::pow(x * x + 0.09 + 1.0, 1.5);
  }
  Lit lit(plate.builder.build("many"));
  EXPECT_NEAR(lit.irradiance(lit.centre(), 64, 64), truth, 3e-3 * truth);
}

TEST(DirectLight, BacksAreDarkAndHideLight) {
  Lit hidden(Plate().lamp(1.0F, 0.5F, 2.0F).lamp(0.5F, 2.0F, 0.0F).builder.build("hidden"));
  EXPECT_EQ(hidden.irradiance(hidden.centre(), 16, 4), 0.0);
  Lit lit(Plate().lamp(1.0F, 0.5F, 2.0F).builder.build("lamp"));
  SurfaceSample below = lit.world.sample_at(0, {0.0F, 0.5F}, {0.0F, 0.0F, -1.0F});
  EXPECT_FALSE(below.lit_side);
  EXPECT_EQ(lit.irradiance(below, 16, 4), 0.0);
  const SurfaceSample lamp = lit.world.sample_at(2, {0.3F, 0.3F}, {0.0F, 0.0F, -1.0F});
  const SurfaceSample lamp_back = lit.world.sample_at(2, {0.3F, 0.3F}, {0.0F, 0.0F, 1.0F});
  EXPECT_EQ(lit.light.emission(lamp), Rgb(2.0F));
  EXPECT_EQ(lit.light.emission(lamp_back), Rgb());
}

TEST(DirectLight, RadianceIsEmissionPlusTheAlbedoTimesIrradianceOverPi) {
  Lit lit(Plate().lamp(1.0F, 0.5F, 2.0F).builder.build("lamp"));
  RayStream rays(lit.world.rays(), lit.counts);
  const Rgb irradiance = lit.light.irradiance(lit.centre(), 9, 64, rays);
  const Rgb radiance = lit.light.radiance(lit.centre(), glm::normalize(Vec3(0.3F, 0.1F, 1.0F)), 9, 64, rays);
  EXPECT_NEAR(radiance.r, 0.5F / pi * irradiance.r, 1e-5F);
  EXPECT_TRUE(is_black(lit.light.radiance(lit.centre(), {0.0F, 0.6F, -0.8F}, 9, 64, rays)));
}

/// A plate, a block and a lamp, under a sky, a sun and a point light.
Scene every_kind_of_light() {
  Plate plate;
  plate.lamp(1.0F, 0.3F, 2.0F).builder.block("block", plate.white, {0.1F, 0.1F, 0.0F}, {0.3F, 0.3F, 0.3F});
  plate.builder.light(EnvironmentLight());
  plate.builder.light(DirectionalLight{glm::normalize(Vec3(1.0F, 0.5F, -1.0F)), Rgb(3.0F)});
  plate.builder.light(PointLight{{-0.4F, 0.2F, 0.3F}, Rgb(0.2F)});
  return plate.builder.build("every kind of light");
}

TEST(DirectLight, ManyPointsAtOnceGetWhatEachGetsAlone) {
  Lit lit(every_kind_of_light());
  RayStream rays(lit.world.rays(), lit.counts);
  std::vector<SurfaceSample> points = area_uniform_samples(lit.world, 200, 3);
  points[20] = lit.world.sample_at(0, {0.0F, 0.5F}, {0.0F, 0.0F, -1.0F});
  std::vector<std::uint64_t> keys;
  std::vector<Vec3> viewers;
  for (std::size_t i = 0; i < points.size(); ++i) {
    keys.push_back(mix_bits(i + 1));
    viewers.push_back(i % 7 == 0 ? -points[i].normal : points[i].normal);
  }
  std::vector<Rgb> irradiance(points.size()), radiance(points.size());
  for (const int samples : {1, 3, 100}) {
    lit.light.irradiance(points, keys, samples, rays, irradiance);
    lit.light.radiance(points, viewers, keys, samples, rays, radiance);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Rgb alone = lit.light.irradiance(points[i], keys[i], samples, rays);
      EXPECT_NEAR(irradiance[i].g, alone.g, 1e-5F * alone.g);
      const Rgb seen = lit.light.radiance(points[i], viewers[i], keys[i], samples, rays);
      EXPECT_NEAR(radiance[i].g, seen.g, 1e-5F * seen.g);
    }
  }
}

TEST(DirectLight, ManyPointsShareTheirPackets) {
  const test::CountedWorld counted(every_kind_of_light());
  const DirectLight light(counted.world, Lighting::of(counted.world.scene()));
  RayCounts counts;
  const std::vector<SurfaceSample> points = area_uniform_samples(counted.world, 256, 3);
  const std::vector<std::uint64_t> keys(points.size(), 1);
  std::vector<Rgb> irradiance(points.size());
  const std::uint64_t calls_before = counted.calls;
  {
    RayStream rays(counted.world.rays(), counts);
    light.irradiance(points, keys, 1, rays, irradiance);
  }
  EXPECT_GT((counts.closest_hit + counts.occlusion) / (counted.calls - calls_before), 32U) << "four full packets of eight";
}

TEST(DirectLight, TheSameKeyGivesTheSameBits) {
  Lit lit(Plate().lamp(1.0F, 0.5F, 2.0F).builder.build("lamp"));
  RayStream rays(lit.world.rays(), lit.counts);
  EXPECT_EQ(lit.light.irradiance(lit.centre(), 9, 16, rays), lit.light.irradiance(lit.centre(), 9, 16, rays));
  EXPECT_NE(lit.light.irradiance(lit.centre(), 9, 16, rays), lit.light.irradiance(lit.centre(), 10, 16, rays));
}

TEST(DirectLight, IsDarkWithoutLights) {
  Lit lit(Plate().builder.build("dark"));
  EXPECT_TRUE(lit.light.dark());
  EXPECT_EQ(lit.irradiance(lit.centre(), 16, 1), 0.0);
}

TEST(SpotLight, FallsOffSmoothlyBetweenItsCones) {
  const SpotLight spot{{0, 0, 0}, {0, 0, -1}, Rgb(4.0F), 0.9F, 0.5F};
  const auto at = [&](float cosine) { return spot_intensity(spot, {std::sqrt(1.0F - cosine * cosine), 0.0F, -cosine}).r; };
  EXPECT_FLOAT_EQ(at(0.95F), 4.0F);
  EXPECT_FLOAT_EQ(at(0.4F), 0.0F);
  EXPECT_NEAR(at(0.7F), 2.0F, 1e-5F);
  EXPECT_NEAR(at(0.6F), 4.0F * (3.0F * 0.0625F - 2.0F * 0.015625F), 1e-5F);
}

TEST(LightChoice, DrawsEachLightWithItsProbability) {
  // Three sources: a lamp of two triangles, a faint lamp, a dark one.
  const LightChoice choice({6.0, 2.0, 1e-6, 0.0}, {0, 0, 1, 2});
  EXPECT_NEAR(choice.probability(0), 0.75F * (0.5F + 0.25F), 1e-5F);
  EXPECT_NEAR(choice.probability(2), 0.25F, 1e-5F);
  EXPECT_EQ(choice.probability(3), 0.0F);
  std::array<int, 4> seen{};
  constexpr int count = 1 << 16;
  for (std::uint32_t i = 0; i < count; ++i) ++seen[choice.choose(i << 16U)];
  for (std::size_t light = 0; light < 4; ++light) EXPECT_NEAR(seen[light], count * choice.probability(light), 2.0) << light;
  EXPECT_LT(choice.choose(0xffffffffU), 3U);
  EXPECT_TRUE(LightChoice({0.0, 0.0}, {0, 1}).empty());
  EXPECT_TRUE(LightChoice({}, {}).empty());
}

}  // namespace
}  // namespace gibench
