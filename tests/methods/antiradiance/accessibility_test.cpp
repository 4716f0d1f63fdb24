/// Accessibility in passes against closed forms and traced rays.
#include "methods/antiradiance/accessibility.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include "common/core/sampling.h"
#include "common/finite_elements/polygon_form_factor.h"
#include "common/geometry/surface_sampling.h"
#include "common/scene/made_scenes.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/form_factor.h"
#include "methods/antiradiance/sky_as_ambient.h"

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
    for (const int passes : {2, 3, 4}) {
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
  accessibility.compute(3, task);
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
    accessibility.compute(3, task);
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
  accessibility.compute(3, task);
  // Nought, but for the undersides of blocks that stand on the floor's plane.
  EXPECT_LT(Sampled(world).error(world, accessibility), 0.02);
}

TEST(Accessibility, BySectorsIsTheSameNaiveAndHierarchical) {
  Task task;
  const World world(yard());
  const Discretisation parts(world, settings("1000"), task);
  Accessibility fast(parts.elements, parts.hierarchy, far_enough, 8), naive(parts.elements, parts.hierarchy, 0.0F, 8);
  fast.compute(3, task);
  naive.compute(3, task);
  EXPECT_LT(fast.evaluations(), naive.evaluations());
  for (const SurfaceSample& sample : area_uniform_samples(world, 300, 6)) {
    const Vec3 point = world.ray_origin(sample);
    EXPECT_NEAR(fast.at(point, sample.normal), naive.at(point, sample.normal), 0.02F);
  }
}

/// A small square above the point, and a square of twice its size at twice the height: seen under one solid angle.
Scene two_plates() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("low", white, {{{-0.5F, 1.0F, -0.5F}, {0.5F, 1.0F, -0.5F}, {0.5F, 1.0F, 0.5F}, {-0.5F, 1.0F, 0.5F}}}, true);
  builder.quad("high", white, {{{-1.0F, 2.0F, -1.0F}, {1.0F, 2.0F, -1.0F}, {1.0F, 2.0F, 1.0F}, {-1.0F, 2.0F, 1.0F}}}, true);
  return builder.build("two plates");
}

/// Form factor of a point to a parallel square of this half side, straight above it.
double square_share(double half_side, double height) {
  const double x = half_side / height, root = std::sqrt(1.0 + x * x);
  return 4.0 / pi_double * x / root * std::atan(x / root);
}

TEST(Accessibility, OfTwoPassesIsTheMeanOfTheFirstAndTheSecond) {
  const double each = square_share(0.5, 1.0);
  // Of the low plate's upper side the high one leaves this much, in the mean over what the point sees of it.
  constexpr int steps = 40;
  double open = 0.0, shares = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const Vec3 at((static_cast<float>(i) + 0.5F) / steps - 0.5F, 1.0F, (static_cast<float>(k) + 0.5F) / steps - 0.5F);
      const std::array<Vec3, 4> high{Vec3(-1.0F, 2.0F, -1.0F), Vec3(1.0F, 2.0F, -1.0F), Vec3(1.0F, 2.0F, 1.0F),
                                     Vec3(-1.0F, 2.0F, 1.0F)};
      const double share = std::pow(static_cast<double>(glm::dot(at, at)), -2.0);  // cos cos / r², at a height of 1
      open += share * (1.0 - static_cast<double>(polygon_form_factor(at, {0.0F, 1.0F, 0.0F}, high)));
      shares += share;
    }
  open /= shares;
  // The first pass: both block whole. The second: the low one blocks what reaches it. The third is the second again.
  const double first = 1.0 - 2.0 * each, second = 1.0 - each - each * open;
  Task task;
  const World world(two_plates());
  const Discretisation parts(world, settings("1500"), task);
  const std::array<double, 3> expected{first, 0.5 * (first + second), second};
  for (int passes = 1; passes <= 3; ++passes) {
    Accessibility accessibility(parts.elements, parts.hierarchy, 0.0F, 1);
    accessibility.compute(passes, task);
    EXPECT_NEAR(accessibility.at(Vec3(0.0F), {0.0F, 1.0F, 0.0F}), expected[static_cast<std::size_t>(passes) - 1], 0.005)
        << passes;
  }
}

/// Half of the sky: bright where x > 0 before it is turned.
EnvironmentLight half_sky(float rotate_y_degrees) {
  auto image = std::make_shared<EnvironmentImage>();
  image->width = 64, image->height = 32;
  for (int row = 0; row < image->height; ++row)
    for (int column = 0; column < image->width; ++column) image->pixels.emplace_back(2 * column >= image->width ? 1.0F : 0.0F);
  return {Rgb(1.0F), image, rotate_y_degrees};
}

TEST(SkyAsAmbient, LightsASurfaceFromWhereItLooks) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("to the right", white, {{{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 1.0F}}}, true);
  const World world(builder.build("card"));
  Task task;
  Settings rule = settings("100");
  rule.sectors = 8;
  const Discretisation parts(world, rule, task);
  for (const float turn : {0.0F, 90.0F, 200.0F}) {
    const Lighting lighting{{half_sky(turn)}, std::vector<Rgb>(world.scene().materials.size())};
    Accessibility accessibility(parts.elements, parts.hierarchy, far_enough, rule.sectors);
    accessibility.compute(3, task);
    const SkyAsAmbient sky(world, lighting, {}, accessibility.sectors());
    const DirectLight exact(world, lighting);
    RayStream rays = task.rays(world);
    for (const float side : {1.0F, -1.0F}) {
      SurfaceSample sample = world.sample_at(0, {0.3F, 0.3F}, {side, 0.0F, 0.0F});
      const float wanted = exact.irradiance(sample, 1, 4096, rays).g;
      // Of sectors that the border of the sky crosses, the mean counts.
      EXPECT_NEAR(sky.answer(sample, nullptr, 1, 1, accessibility, rays).g, wanted, 0.05F * pi) << turn << ' ' << side;
    }
  }
}

}  // namespace
}  // namespace gibench::antiradiance
