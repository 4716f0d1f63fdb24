/// Accessibility in passes against closed forms and traced rays.
#include "methods/antiradiance/accessibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/core/sampling.h"
#include "common/geometry/surface_sampling.h"
#include "common/scene/made_scenes.h"
#include "methods/antiradiance/discretisation.h"

namespace gibench::antiradiance {
namespace {

constexpr float far_enough = 0.02F;

Settings settings(const char* elements) { return settings_from(Parameters(settings_schema(), {{"elements", elements}})); }

/// Ground on both sides of a wall of 4 × 3 m, which stands in the plane x = 0.
Scene wall_on_ground() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("ground", white, {{{-1.0F, 0.0F, 1.0F}, {1.5F, 0.0F, 1.0F}, {1.5F, 0.0F, -1.0F}, {-1.0F, 0.0F, -1.0F}}});
  builder.quad("wall", white, {{{0.0F, 0.0F, 2.0F}, {0.0F, 0.0F, -2.0F}, {0.0F, 3.0F, -2.0F}, {0.0F, 3.0F, 2.0F}}}, true);
  return builder.build("wall on ground");
}

/// A yard under the sky: walls behind one another, a block, a canopy.
Scene yard() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("ground", white, {{{-1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, -1.0F}, {-1.0F, 0.0F, -1.0F}}});
  builder.quad("wall", white, {{{-0.6F, 0.0F, 1.0F}, {-0.6F, 0.0F, -1.0F}, {-0.6F, 0.8F, -1.0F}, {-0.6F, 0.8F, 1.0F}}}, true);
  builder.quad("fence", white, {{{-0.4F, 0.0F, 0.5F}, {-0.4F, 0.0F, -0.5F}, {-0.4F, 0.4F, -0.5F}, {-0.4F, 0.4F, 0.5F}}}, true);
  builder.block("block", white, {0.0F, 0.0F, -0.3F}, {0.3F, 0.5F, 0.0F}, 25.0F);
  builder.quad("canopy", white, {{{0.2F, 0.7F, 0.8F}, {0.9F, 0.7F, 0.8F}, {0.9F, 0.7F, 0.1F}, {0.2F, 0.7F, 0.1F}}}, true);
  return builder.build("yard");
}

struct Sampled {
  explicit Sampled(const World& world) : samples(area_uniform_samples(world, 200, 5)) {
    constexpr int strata = 32;
    Task task;
    RayStream rays = task.rays(world);
    for (std::size_t k = 0; k < samples.size(); ++k) {
      RandomStream random(1, 2, k);
      int open = 0;
      for (int i = 0; i < strata * strata; ++i) {
        const Vec2 at{(static_cast<float>(i % strata) + random.next_float()) / strata,
                      (static_cast<float>(i / strata) + random.next_float()) / strata};
        const Vec3 direction = Frame(samples[k].normal).to_world(cosine_hemisphere(at));
        if (!rays.closest_hit({world.ray_origin(samples[k]), 0.0F, direction})) ++open;
      }
      traced.push_back(static_cast<double>(open) / (strata * strata));
    }
  }
  double error(const World& world, const Accessibility& accessibility) const {
    double sum = 0.0;
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const auto found = static_cast<double>(accessibility.at(world.ray_origin(samples[k]), samples[k].normal));
      sum += (found - traced[k]) * (found - traced[k]);
    }
    return std::sqrt(sum / static_cast<double>(samples.size()));
  }
  std::vector<SurfaceSample> samples;
  std::vector<double> traced;
};

TEST(Accessibility, IsAHalfAtTheFootOfAWallWithGroundBehindIt) {
  Task task;
  const World world(wall_on_ground());
  const Discretisation parts(world, settings("1500"), task);
  for (const int sectors : {4, 8})
    for (const int passes : {1, 2, 3}) {
      Accessibility accessibility(parts.elements, parts.hierarchy, far_enough, sectors);
      accessibility.compute(passes, task);
      // Half the sky, and what looks past the wall's ends and over its top: 1/2 + 0.0002 at a millimetre.
      EXPECT_NEAR(accessibility.at({0.001F, 1e-5F, 0.0F}, {0.0F, 1.0F, 0.0F}), 0.5002F, 0.015F) << sectors << ' ' << passes;
      EXPECT_NEAR(accessibility.at({0.5F, 1e-5F, 0.0F}, {0.0F, 1.0F, 0.0F}), 0.6084F, 0.018F) << sectors << ' ' << passes;
    }
}

TEST(Accessibility, BySideAloneTakesTheWallsShadowAway) {
  Task task;
  const World world(wall_on_ground());
  const Discretisation parts(world, settings("1500"), task);
  Accessibility accessibility(parts.elements, parts.hierarchy, far_enough, 1);
  accessibility.compute(2, task);
  EXPECT_GT(accessibility.at({0.001F, 1e-5F, 0.0F}, {0.0F, 1.0F, 0.0F}), 0.6F);
}

TEST(Accessibility, ComesToTracedRaysWithSectors) {
  Task task;
  const World world(yard());
  const Discretisation parts(world, settings("1500"), task);
  const Sampled sampled(world);
  std::vector<double> errors;
  for (const int sectors : {1, 4, 8}) {
    Accessibility accessibility(parts.elements, parts.hierarchy, far_enough, sectors);
    accessibility.compute(2, task);
    errors.push_back(sampled.error(world, accessibility));
  }
  EXPECT_LT(errors[1], errors[0]);
  EXPECT_LT(errors[2], errors[1]);
  EXPECT_LT(errors[2], 0.03);
}

TEST(Accessibility, OfAClosedRoomIsThatOfTracedRays) {
  Task task;
  const World world(made::box_scene());
  const Discretisation parts(world, settings("1500"), task);
  Accessibility accessibility(parts.elements, parts.hierarchy, far_enough, 8);
  accessibility.compute(2, task);
  // Nought, but for the undersides of blocks that stand on the floor's plane.
  EXPECT_LT(Sampled(world).error(world, accessibility), 0.02);
}

TEST(Accessibility, BySectorsIsTheSameNaiveAndHierarchical) {
  Task task;
  const World world(yard());
  const Discretisation parts(world, settings("1000"), task);
  Accessibility fast(parts.elements, parts.hierarchy, far_enough, 8), naive(parts.elements, parts.hierarchy, 0.0F, 8);
  fast.compute(2, task);
  naive.compute(2, task);
  EXPECT_LT(fast.evaluations(), naive.evaluations());
  for (const SurfaceSample& sample : area_uniform_samples(world, 300, 6)) {
    const Vec3 point = world.ray_origin(sample);
    EXPECT_NEAR(fast.at(point, sample.normal), naive.at(point, sample.normal), 0.02F);
  }
}

}  // namespace
}  // namespace gibench::antiradiance
