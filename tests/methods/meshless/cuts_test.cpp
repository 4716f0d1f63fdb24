/// Walls that cut the finest basis functions.
#include "methods/meshless/cuts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/meshless/expansion.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

Settings four_levels() {
  Settings settings = test::default_settings();
  settings.levels = 4;
  return settings;
}

/// A floor, and a sheet that stands across it at x = 1.
Scene floor_with_a_wall() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {2, 0, 1}, {2, 0, 0}}});
  builder.quad("wall", white, {{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}}}, true);
  return builder.build("wall");
}

/// Light on one side of the wall alone.
Rgb of_one_side(const Place& at) { return Rgb(at.position.x < 1.0F ? 1.0F : 0.0F); }

/// Places on the floor on both sides of the wall, as far from it.
std::vector<Place> beside_the_wall(const test::BasisScene& scene, float distance) {
  std::vector<Place> places;
  for (int i = 5; i < 95; ++i)
    for (const float side : {-1.0F, 1.0F})
      places.push_back({{1.0F + side * distance, 0.0F, 0.01F * static_cast<float>(i)}, {0, 1, 0}, scene.groups.of(0, true)});
  return places;
}

TEST(Cuts, ConfineFunctionsToTheirSideOfAWall) {
  test::BasisScene scene(floor_with_a_wall(), four_levels());
  Task task;
  cut_at_walls(scene.world, scene.hierarchy, 2, task);
  ASSERT_TRUE(scene.hierarchy.is_cut(3));
  EXPECT_TRUE(scene.hierarchy.is_cut(2));
  EXPECT_FALSE(scene.hierarchy.is_cut(1));
  std::size_t near_it = 0;
  for (std::uint32_t point = scene.hierarchy.level_begin(2); point < scene.hierarchy.size(); ++point) {
    const Vec3& at = scene.hierarchy.position(point);
    if (scene.hierarchy.normal(point).y < 0.5F) continue;
    const float distance = std::fabs(at.x - 1.0F);
    // Four rays around a point come within 45° of any direction, and 2/√5 of a radius far along the floor.
    const bool amid = std::fabs(at.z - 0.5F) < 0.5F - scene.hierarchy.radius(point);  // rays do not pass the wall's ends
    if (amid && distance < 0.63F * scene.hierarchy.radius(point)) {
      ++near_it;
      EXPECT_NEAR(std::fabs(scene.hierarchy.cut(point, 0).normal.x), 1.0F, 1e-5F);
      EXPECT_TRUE(scene.hierarchy.cut(point, 0).keeps(at));
      EXPECT_FALSE(scene.hierarchy.cut(point, 0).keeps({2.0F - at.x, 0.0F, at.z}));
    } else if (distance > 1.01F * scene.hierarchy.radius(point)) {
      EXPECT_EQ(scene.hierarchy.cut(point, 0).normal, Vec3(0.0F)) << distance;
    }
    EXPECT_EQ(scene.hierarchy.cut(point, 1).normal, Vec3(0.0F)) << "there is one wall";
  }
  EXPECT_GT(near_it, 20U);
}

TEST(Cuts, InAGapAreBothOfItsWalls) {
  constexpr float gap = 0.03F;  // metres
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {2, 0, 1}, {2, 0, 0}}});
  for (const float x : {1.0F, 1.0F + gap}) {
    const std::array<Vec3, 4> corners{{{x, 0, 0}, {x, 0, 1}, {x, 1, 1}, {x, 1, 0}}};
    builder.quad(x > 1.0F ? "right" : "left", white, corners, true);
  }
  test::BasisScene scene(builder.build("gap"), four_levels());
  Task task;
  cut_at_walls(scene.world, scene.hierarchy, 2, task);
  std::size_t in_it = 0;
  for (std::uint32_t point = scene.hierarchy.level_begin(2); point < scene.hierarchy.size(); ++point) {
    const Vec3& at = scene.hierarchy.position(point);
    const float radius = scene.hierarchy.radius(point), left = at.x - 1.0F, right = 1.0F + gap - at.x;
    if (scene.hierarchy.normal(point).y < 0.5F || std::fabs(at.z - 0.5F) > 0.5F - radius) continue;
    // As for one wall; of opposite rays, one meets each.
    if (std::min(left, right) <= 0.0F || std::max(left, right) > 0.63F * radius) continue;
    ++in_it;
    const Cut &nearer = scene.hierarchy.cut(point, 0), &farther = scene.hierarchy.cut(point, 1);
    for (const Cut& cut : {nearer, farther}) EXPECT_TRUE(cut.keeps(at));
    const Vec3 beyond_left(0.999F, 0.0F, at.z), beyond_right(1.001F + gap, 0.0F, at.z);
    EXPECT_FALSE((left < right ? nearer : farther).keeps(beyond_left));
    EXPECT_FALSE((left < right ? farther : nearer).keeps(beyond_right));
  }
  EXPECT_GT(in_it, 10U);
}

TEST(Cuts, KeepLightFromLeakingThroughAWall) {
  test::BasisScene scene(floor_with_a_wall(), four_levels());
  const auto miss = [&] {
    const Coefficients made = scene.approximate_fully(3, of_one_side);
    const Expansion expansion(made);
    double sum = 0.0;
    for (const Place& place : beside_the_wall(scene, 0.002F)) {
      const float value = expansion.evaluate(place).g;
      EXPECT_NEAR(value, made.evaluate(place, 3).g, 1e-4F) << "both ways of evaluation are cut alike";
      sum += static_cast<double>(std::fabs(value - of_one_side(place).g)) / 180.0;
    }
    return sum;
  };
  const double uncut = miss();
  Task task;
  cut_at_walls(scene.world, scene.hierarchy, 2, task);
  // Without cuts both sides have the mean of the two. With them the coarse levels' slope within a ball is left: functions one to
  // two radii from the wall see half of the step or less.
  EXPECT_GT(uncut, 0.4);
  EXPECT_LT(miss(), 0.5 * uncut);
}

TEST(Cuts, SpareASurfaceThatBends) {
  // A trough of sixteen strips, round as a half pipe: no strip is a wall to another.
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (std::uint32_t i = 0; i <= 16; ++i) {
    const float angle = pi * static_cast<float>(i) / 16.0F;
    for (const float z : {0.0F, 2.0F}) vertices.push_back({-std::cos(angle), 1.0F - std::sin(angle), z});
    if (i > 0) faces.push_back({2 * i - 2, 2 * i - 1, 2 * i + 1, 2 * i});
  }
  builder.object("trough", white, vertices, faces);
  test::BasisScene scene(builder.build("trough"), four_levels());
  Task task;
  cut_at_walls(scene.world, scene.hierarchy, 2, task);
  for (std::uint32_t point = scene.hierarchy.level_begin(2); point < scene.hierarchy.size(); ++point)
    EXPECT_EQ(scene.hierarchy.cut(point, 0).normal, Vec3(0.0F));
}

}  // namespace
}  // namespace gibench::meshless
