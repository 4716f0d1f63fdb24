#include "methods/meshless/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/scene/made_scenes.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

Settings small_settings(int levels = 3) {
  Settings settings = test::default_settings();
  settings.levels = levels;
  return settings;
}

/// The k-th smallest distance to a point of the same level and group that a weight could reach.
float brute_force_radius(const Hierarchy& hierarchy, std::uint32_t point, int neighbours, float limit) {
  std::vector<float> distances;
  const std::uint32_t level = hierarchy.level_of(point);
  for (std::uint32_t other = hierarchy.level_begin(level); other < hierarchy.level_begin(level + 1); ++other)
    if (other != point && hierarchy.group_of(other) == hierarchy.group_of(point) &&
        glm::dot(hierarchy.normal(point), hierarchy.normal(other)) > least_cosine)
      distances.push_back(glm::distance(hierarchy.position(point), hierarchy.position(other)));
  std::sort(distances.begin(), distances.end());
  const auto wanted = static_cast<std::size_t>(neighbours);
  return std::min(limit, distances.size() < wanted ? limit : distances[wanted - 1]);
}

TEST(Hierarchy, RadiusIsTheDistanceToTheKthNeighbourThatAWeightCouldReach) {
  const test::BasisScene scene(made::box_scene(), small_settings());
  const Hierarchy& hierarchy = scene.hierarchy;
  Task task;
  double disc = place_points(scene.world, scene.groups, scene.settings, task).radius;
  std::size_t at_limit = 0;
  for (std::uint32_t level = 0; level < hierarchy.levels(); ++level, disc *= 0.5) {
    const auto limit = static_cast<float>(scene.settings.radius_limit * disc);
    for (std::uint32_t point = hierarchy.level_begin(level); point < hierarchy.level_begin(level + 1); point += 3) {
      const float expected = brute_force_radius(hierarchy, point, scene.settings.neighbours, limit);
      EXPECT_NEAR(hierarchy.radius(point), expected, 1e-5F * limit);
      at_limit += expected == limit ? 1U : 0U;
    }
  }
  EXPECT_GT(at_limit, 0U);                      // the lamp is too small for ten coarse neighbours
  EXPECT_LT(at_limit, hierarchy.size() / 10U);  // and everything else is not
}

TEST(Hierarchy, KeepsEveryPlacedPointOnce) {
  const test::BasisScene scene(made::box_scene(), small_settings());
  Task task;
  const Placement placement = place_points(scene.world, scene.groups, scene.settings, task);
  std::size_t placed = 0;
  for (const auto& level : placement.points)
    for (const auto& group : level) placed += group.size();
  EXPECT_EQ(scene.hierarchy.size(), placed);
  EXPECT_EQ(scene.hierarchy.levels(), 3U);
  EXPECT_NEAR(scene.hierarchy.level_size(0), 310.0, 20.0);
  for (std::uint32_t point = 0; point < scene.hierarchy.size(); point += 7) {
    const Vec3& front = scene.world.normal(scene.hierarchy.triangle(point));
    const Vec3 normal = scene.hierarchy.on_front(point) ? front : -front;
    EXPECT_GT(glm::dot(scene.hierarchy.normal(point), normal), 0.99999F);
    EXPECT_EQ(scene.groups.of_triangle[scene.hierarchy.triangle(point)], scene.hierarchy.group_of(point));
  }
}

TEST(Hierarchy, FindsExactlyTheCoveringFunctions) {
  const test::BasisScene scene(made::box_scene(), small_settings());
  const Hierarchy& hierarchy = scene.hierarchy;
  for (const Place& at : scene.places(200))
    for (std::uint32_t level = 0; level < hierarchy.levels(); ++level) {
      std::vector<std::uint32_t> found, expected;
      hierarchy.visit_covering(level, at, [&](std::uint32_t point, float w) {
        EXPECT_GT(w, 0.0F);
        found.push_back(point);
      });
      for (std::uint32_t point = hierarchy.level_begin(level); point < hierarchy.level_begin(level + 1); ++point) {
        const float distance = glm::distance(at.position, hierarchy.position(point));
        if (hierarchy.group_of(point) == at.group &&
            weight(distance * distance, hierarchy.radius(point), glm::dot(at.normal, hierarchy.normal(point))) > 0.0F)
          expected.push_back(point);
      }
      std::sort(found.begin(), found.end());
      EXPECT_EQ(found, expected);
    }
}

TEST(Hierarchy, CoversEverySurfacePointOnTheCoarsestLevel) {
  const test::BasisScene scene(made::box_scene(), small_settings(1));
  std::vector<SurfaceSample> samples = area_uniform_samples(scene.world, 2000, 4);
  std::vector<DiscPoint> points;
  for (const SurfaceSample& sample : samples) points.push_back({sample.position, sample.normal, {sample.triangle, true}});
  std::vector<std::uint8_t> clear(points.size(), 1);
  Task task;
  clear_of_backfaces(scene.world, points, clear, 16, task);
  std::size_t inside = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::size_t covering = 0;
    scene.hierarchy.visit_covering(0, scene.place(samples[i]), [&](std::uint32_t, float) { ++covering; });
    if (clear[i] != 0) {
      EXPECT_GT(covering, 0U) << i;
    } else {
      ++inside;
    }
  }
  EXPECT_GT(inside, 10U);  // the floor under the blocks
}

TEST(Placement, PutsNoPointInsideClosedGeometryAndAllUnderACanopy) {
  const test::BasisScene box(made::box_scene(), small_settings());
  for (std::uint32_t point = 0; point < box.hierarchy.size(); ++point) {
    const Vec3& at = box.hierarchy.position(point);
    if (at.y < 1e-4F && box.hierarchy.normal(point).y > 0.5F) {
      // The tall block's foot, 0.15 each way and turned by 17°, holds a square of 0.15 / (cos 17° + sin 17°) each way.
      EXPECT_GT(std::max(std::fabs(at.x - 0.3F), std::fabs(at.z - 0.3F)), 0.12F);
    }
  }
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("canopy", white, {{{0.2F, 0.5F, 0.2F}, {0.2F, 0.5F, 0.8F}, {0.8F, 0.5F, 0.8F}, {0.8F, 0.5F, 0.2F}}});
  const auto below = [](const Hierarchy& hierarchy) {
    std::size_t count = 0;
    for (std::uint32_t point = 0; point < hierarchy.size(); ++point) {
      const Vec3& at = hierarchy.position(point);
      count += at.y < 0.1F && std::max(std::fabs(at.x - 0.5F), std::fabs(at.z - 0.5F)) < 0.25F ? 1U : 0U;
    }
    return count;
  };
  Settings paper = small_settings(2);
  paper.backface_rays = 1;
  EXPECT_EQ(below(test::BasisScene(builder.build("canopy"), paper).hierarchy), 0U);
  EXPECT_GT(below(test::BasisScene(builder.build("canopy"), small_settings(2)).hierarchy), 50U);
}

TEST(Groups, FollowTheSceneAndItsConnectedComponents) {
  Scene scene = made::box_scene();
  const World plain(scene, 1);
  EXPECT_EQ(make_groups(plain, Grouping::objects).count, 1U);
  EXPECT_EQ(make_groups(plain, Grouping::components).count, 4U);  // room, two blocks, lamp
  EXPECT_EQ(make_groups(plain, Grouping::automatic).count, 4U);
  scene.objects[0].group = "floor";
  const World grouped(scene, 1);
  EXPECT_EQ(make_groups(grouped, Grouping::objects).count, 2U);
  const World many(made::random_triangles(100, 1.0F, 0.1F, 3), 1);
  EXPECT_EQ(make_groups(many, Grouping::components).count, 100U);
  EXPECT_EQ(make_groups(many, Grouping::automatic).count, 1U);
}

}  // namespace
}  // namespace gibench::meshless
