// Triangles as lights: solid angles, and points drawn on them by area and by solid angle.
#include <gtest/gtest.h>

#include <cmath>

#include "common/core/sobol.h"
#include "common/lighting/mis.h"
#include "common/lighting/spherical_triangle.h"
#include "common/lighting/triangle_emitter.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

TEST(SphericalTriangle, KnowsItsSolidAngle) {
  const SphericalTriangle octant({3.0, 0.0, 0.0}, {0.0, 0.1, 0.0}, {0.0, 0.0, 7.0});
  EXPECT_NEAR(octant.solid_angle(), 0.5 * pi_double, 1e-12);
  // One of the 24 right triangles that the faces of a cube fall into when both diagonals are drawn.
  const SphericalTriangle part({1.0, 1.0, 1.0}, {1.0, 1.0, -1.0}, {1.0, 0.0, 0.0});
  EXPECT_NEAR(part.solid_angle(), 4.0 * pi_double / 24.0, 1e-12);
  // Far away: area cos / d².
  const SphericalTriangle far({0.0, 0.0, 1e4}, {1.0, 0.0, 1e4}, {0.0, 1.0, 1e4});
  EXPECT_NEAR(far.solid_angle(), 0.5e-8, 1e-12);
}

TEST(SphericalTriangle, SamplesUniformlyBySolidAngle) {
  // The mean direction over a spherical triangle is half the sum of its sides' arcs times their inward normals, over its
  // solid angle (Lambert). Equal shares fall on both sides of a plane that halves the triangle.
  const Vec3d a{0.2, 0.6, 1.4}, b{1.5, 0.8, 0.2}, c{0.5, -0.5, 0.4};
  const SphericalTriangle triangle(a, b, c);
  const auto edge = [](const Vec3d& p, const Vec3d& q) {
    const Vec3d side = glm::cross(p, q);
    return std::atan2(glm::length(side), glm::dot(p, q)) * glm::normalize(side);
  };
  Vec3d expected = 0.5 * (edge(a, b) + edge(b, c) + edge(c, a)) / triangle.solid_angle();
  if (glm::dot(expected, a + b + c) < 0.0) expected = -expected;
  const SobolSequence sequence(1);
  constexpr std::uint32_t count = 1 << 14;
  Vec3d sum{0.0};
  for (std::uint32_t i = 0; i < count; ++i) {
    const auto drawn = triangle.sample(sequence.pair(i, 0).unit());
    ASSERT_TRUE(drawn);
    EXPECT_GE(drawn->x, 0.0F);
    EXPECT_GE(drawn->y, 0.0F);
    EXPECT_LE(drawn->x + drawn->y, 1.0F + 1e-6F);
    sum += glm::normalize(a + static_cast<double>(drawn->x) * (b - a) + static_cast<double>(drawn->y) * (c - a));
  }
  EXPECT_NEAR(glm::length(sum / static_cast<double>(count) - expected), 0.0, 1e-3);
}

TEST(SphericalTriangle, StaysFiniteSeenFromItsPlaneAndItsCorners) {
  const SobolSequence sequence(2);
  for (const Vec3d& from : {Vec3d(0.0), Vec3d(0.3, 0.3, 0.0), Vec3d(2.0, 0.0, 0.0), Vec3d(0.3, 0.3, 1e-9)}) {
    const SphericalTriangle triangle(Vec3d(0.0) - from, Vec3d(1.0, 0.0, 0.0) - from, Vec3d(0.0, 1.0, 0.0) - from);
    for (std::uint32_t i = 0; i < 200; ++i)
      if (const auto drawn = triangle.sample(sequence.pair(i, 0).unit())) {
        EXPECT_TRUE(std::isfinite(drawn->x) && std::isfinite(drawn->y));
      }
  }
}

/// One triangle in the plane z = 0 whose front looks up.
World triangle_world(bool two_sided) {
  made::SceneBuilder builder;
  builder.object("lamp", builder.diffuse("lamp", Rgb(), Rgb(2.0F)), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 2}}, two_sided);
  return World(builder.build("lamp"), 1);
}

TEST(TriangleEmitter, DensitiesIntegrateToOneNearAndFar) {
  const World world = triangle_world(false);
  const TriangleEmitter emitter(world, 0, false, Rgb(2.0F));
  for (const Vec3& from : {Vec3(0.2F, 0.2F, 0.01F), Vec3(0.2F, 0.2F, 0.5F), Vec3(3.0F, 1.0F, 5.0F), Vec3(1.5F, 0.2F, 0.05F)}) {
    // ∫ pdf dω over the triangle, by area.
    constexpr int steps = 2000;
    double sum = 0.0;
    for (int i = 0; i < steps; ++i)
      for (int j = 0; j < steps - i; ++j) {
        const Vec3 point{(static_cast<float>(i) + 1.0F / 3.0F) / steps, (static_cast<float>(j) + 1.0F / 3.0F) / steps, 0.0F};
        const float distance = glm::distance(point, from), cosine = from.z / distance;
        const double weight = j == steps - i - 1 ? 0.5 : 1.0;
        sum += weight * static_cast<double>(emitter.pdf(from, distance, cosine) * cosine / (distance * distance));
      }
    EXPECT_NEAR(sum / (static_cast<double>(steps) * steps), 1.0, 6e-3) << from.z;
  }
}

TEST(TriangleEmitter, SamplesSayTheirOwnDensity) {
  const World world = triangle_world(false);
  const TriangleEmitter emitter(world, 0, false, Rgb(2.0F));
  const SobolSequence sequence(3);
  for (const Vec3& from : {Vec3(0.2F, 0.2F, 0.01F), Vec3(0.2F, 0.2F, 0.5F), Vec3(3.0F, 1.0F, 5.0F)})
    for (std::uint32_t i = 0; i < 500; ++i) {
      const LightSample sample = emitter.sample(from, sequence.pair(i, 0).unit());
      ASSERT_GT(sample.pdf, 0.0F);
      const Hit hit = world.rays().closest_hit({from, 0.0F, sample.direction});
      ASSERT_TRUE(hit);
      EXPECT_NEAR(emitter.pdf(from, hit.distance, -sample.direction.z), sample.pdf, 2e-3F * sample.pdf);
      EXPECT_FALSE(world.rays().occluded(sample.shadow_ray(from)));
    }
}

TEST(TriangleEmitter, IsBlackBehindUnlessTwoSided) {
  const World one = triangle_world(false), two = triangle_world(true);
  const Vec3 behind{0.2F, 0.3F, -1.0F};
  EXPECT_EQ(TriangleEmitter(one, 0, false, Rgb(2.0F)).sample(behind, {0.4F, 0.6F}).pdf, 0.0F);
  const LightSample sample = TriangleEmitter(two, 0, true, Rgb(2.0F)).sample(behind, {0.4F, 0.6F});
  EXPECT_GT(sample.pdf, 0.0F);
  EXPECT_FALSE(two.rays().occluded(sample.shadow_ray(behind)));
  EXPECT_NEAR(TriangleEmitter(one, 0, false, Rgb(2.0F)).power(), pi_double, 1e-6);
  EXPECT_NEAR(TriangleEmitter(two, 0, true, Rgb(2.0F)).power(), 2.0 * pi_double, 1e-6);
}

TEST(PowerHeuristic, SharesOneBetweenTwoTechniques) {
  for (const float a : {1e-30F, 0.3F, 1e25F})
    for (const float b : {1e-25F, 1.0F, 1e30F}) EXPECT_NEAR(power_heuristic(a, b) + power_heuristic(b, a), 1.0F, 1e-6F);
  EXPECT_EQ(power_heuristic(2.0F, 0.0F), 1.0F);
  EXPECT_NEAR(power_heuristic(3.0F, 4.0F), 9.0F / 25.0F, 1e-6F);
}

}  // namespace
}  // namespace gibench
