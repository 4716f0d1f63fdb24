#include "methods/meshless/hierarchy.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/meshless/coarsest_shares.h"
#include "methods/meshless/refinement.h"
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
    EXPECT_EQ(scene.groups.of(scene.hierarchy.triangle(point), scene.hierarchy.on_front(point)), scene.hierarchy.group_of(point));
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
  EXPECT_EQ(make_groups(many, Grouping::automatic).count, most_own_groups + 1U);
}

TEST(Groups, TheSidesOfATwoSidedSheetAreApart) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("sheet", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}}, true);
  builder.quad("floor", white, {{{0, -1, 0}, {0, -1, 1}, {1, -1, 1}, {1, -1, 0}}});
  const World world(builder.build("sheet"), 1);
  for (const Grouping grouping : {Grouping::components, Grouping::automatic}) {
    const Groups groups = make_groups(world, grouping);
    EXPECT_EQ(groups.count, 3U);
    EXPECT_NE(groups.of(0, true), groups.of(0, false));
    EXPECT_EQ(groups.of(0, true), groups.of(1, true));
    EXPECT_EQ(groups.of(2, true), groups.of(2, false)) << "a black back is nobody's";
    SurfaceSample below = world.sample_at(0, {0.2F, 0.2F}, {0.0F, -1.0F, 0.0F});
    EXPECT_EQ(groups.of(below), groups.of(0, glm::dot(world.normal(0), Vec3(0, -1, 0)) > 0.0F));
  }
  EXPECT_EQ(make_groups(world, Grouping::objects).of(0, true), make_groups(world, Grouping::objects).of(0, false));
}

/// Two rooms whose walls touch, one object of a group; a lamp lights the first. Two triangles a wall, the dark room's last.
Scene lit_and_sealed_room() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("lit", white, {0, 0, 0}, {1, 1, 1}).room("sealed", white, {1, 0, 0}, {2, 1, 1});
  builder.light(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  Scene scene = builder.build("rooms");
  for (Object& object : scene.objects) object.group = "house";
  return scene;
}

TEST(Groups, SealedSidesAreApartFromLitOnesOfTheSameSurface) {
  const World world(lit_and_sealed_room(), 1);
  Task task;
  const SideLight light(world, task);
  EXPECT_EQ(make_groups(world, Grouping::automatic).count, 1U);
  const Groups groups = make_groups(world, Grouping::automatic, &light);
  ASSERT_EQ(groups.count, 2U);
  for (std::uint32_t t = 0; t < 24; ++t) EXPECT_EQ(groups.sealed[groups.of(t, true)], t < 12 ? 0 : 1) << t;
}

TEST(Placement, CoarsestSamplesAreThoseThatLightReaches) {
  const World world(lit_and_sealed_room(), 1);
  Task task;
  const SideLight light(world, task);
  const Groups groups = make_groups(world, Grouping::automatic, &light);
  const Placement placement = place_points(world, groups, small_settings(1), task);
  for (std::uint32_t group = 0; group < 2; ++group)
    EXPECT_NEAR(static_cast<double>(placement.points[0][group].size()), 310.0, 40.0) << "rooms of the same size";
}

TEST(Placement, DiscsAreSmallerWhereSurfacesSeeWhatIsNear) {
  // Two plates, ten wide: the sides that face each other see a tenth of their width away at most, or a hundredth.
  const auto coarsest = [](float gap, double feature_radius) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
    builder.quad("floor", white, {{{0, 0, 0}, {0, 0, 10}, {10, 0, 10}, {10, 0, 0}}});
    builder.quad("ceiling", white, {{{0, gap, 0}, {10, gap, 0}, {10, gap, 10}, {0, gap, 10}}});
    Settings settings = small_settings(1);
    settings.feature_radius = feature_radius;
    const World world(builder.build("plates"), 1);
    Task task;
    std::size_t count = 0;
    const Placement placement = place_points(world, make_groups(world, Grouping::automatic), settings, task);
    for (const std::vector<DiscPoint>& group : placement.points[0]) count += group.size();
    return static_cast<double>(count);
  };
  EXPECT_NEAR(coarsest(10.0F, 0.5), 310.0, 20.0) << "far apart in comparison with discs";
  EXPECT_NEAR(coarsest(0.1F, 0.5), 1600.0, 160.0);
  EXPECT_NEAR(coarsest(0.1F, 0.0), 310.0, 20.0);
}

/// Blocks of one object, each smaller than the one before, in a room.
Scene room_with_blocks(std::uint32_t count) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, {0, 0, 0}, {10, 10, 10});
  for (std::uint32_t i = 0; i < count; ++i) {
    const float size = 0.5F / (1.0F + 0.1F * static_cast<float>(i)), x = 0.5F + static_cast<float>(i % 9),
                z = 0.5F + static_cast<float>(i / 9);
    builder.block("block" + std::to_string(i), white, {x, 1.0F, z}, {x + size, 1.0F + size, z + size});
  }
  Scene scene = builder.build("room with blocks");
  for (Object& object : scene.objects) object.group = object.name == "room" ? "room" : "blocks";
  return scene;
}

TEST(Groups, OneMoreSmallComponentChangesNoGroupButTheSmallest) {
  const World few(room_with_blocks(most_own_groups - 1), 1), more(room_with_blocks(most_own_groups + 3), 1);
  const Groups before = make_groups(few, Grouping::automatic), after = make_groups(more, Grouping::automatic);
  EXPECT_EQ(before.count, most_own_groups);
  EXPECT_EQ(after.count, most_own_groups + 1);
  ASSERT_LT(before.of_side.size(), after.of_side.size());
  for (std::size_t t = 0; t < before.of_side.size(); ++t) EXPECT_EQ(after.of_side[t], before.of_side[t]);
  for (std::size_t t = before.of_side.size(); t < after.of_side.size(); ++t)
    EXPECT_EQ(after.of_side[t], most_own_groups) << "the smallest share a group";
}

TEST(Groups, PolygonsThatAbutWithTJunctionsAreOneSurface) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  // A long tile, at whose edge shorter ones lie, turned so that their corners are on it but for rounding; and one apart.
  const auto tile = [&](const char* name, float x0, float x1, float z0, float z1) {
    const float c = std::cos(0.3F), s = std::sin(0.3F);
    const auto at = [&](float x, float z) { return Vec3(c * x - s * z, 0.0F, s * x + c * z); };
    builder.quad(name, white, {{at(x0, z0), at(x0, z1), at(x1, z1), at(x1, z0)}});
  };
  tile("long", 0.0F, 3.0F, 0.0F, 1.0F);
  tile("left", -0.5F, 0.7F, 1.0F, 2.0F);
  tile("right", 1.1F, 2.2F, 1.0F, 2.0F);
  tile("apart", 1.1F, 2.2F, 2.01F, 3.0F);
  Scene scene = builder.build("tiles");
  for (Object& object : scene.objects) object.group = "floor";
  const World world(scene, 1);
  const Groups groups = make_groups(world, Grouping::components);
  EXPECT_EQ(groups.count, 2U);
  EXPECT_EQ(groups.of(0, true), groups.of(2, true));
  EXPECT_EQ(groups.of(0, true), groups.of(4, true));
  EXPECT_NE(groups.of(0, true), groups.of(6, true));
}

TEST(Groups, ABlockThatStandsOnAFloorIsNotPartOfIt) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, {0, 0, 0}, {1, 1, 1});
  builder.block("block", white, {0.0F, 0.0F, 0.2F}, {0.4F, 0.4F, 0.6F});  // in the corner of floor and wall
  EXPECT_EQ(make_groups(World(builder.build("block on a floor"), 1), Grouping::components).count, 2U);
}

TEST(Placement, SettingsThatAskForTooManyPointsAreRefusedByName) {
  made::SceneBuilder builder;
  builder.quad("floor", builder.diffuse("white", Rgb(0.5F)), {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  const World world(builder.build("floor"), 1);
  const auto refusal_with = [&](int levels, double initial_radius) {
    Settings settings = test::default_settings();
    settings.levels = levels;
    settings.initial_radius = initial_radius;
    Task task;
    const Placement placement = place_points(world, make_groups(world, Grouping::objects), settings, task);
    EXPECT_TRUE(placement.refusal.empty() || placement.points.empty());
    return placement.refusal;
  };
  EXPECT_NE(refusal_with(12, 0.0).find("levels=12 with coarsest_samples=310"), std::string::npos) << refusal_with(12, 0.0);
  EXPECT_NE(refusal_with(1, 1e-12).find("initial_radius=1e-12"), std::string::npos) << refusal_with(1, 1e-12);
  EXPECT_EQ(refusal_with(2, 0.0), "");
}

TEST(Hierarchy, RadiiFollowTheirNeighboursHoweverLargeTheLimitIs) {
  made::SceneBuilder builder;
  builder.quad("floor", builder.diffuse("white", Rgb(0.5F)), {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  Settings near = small_settings(2), far = near;
  far.radius_limit = 1e6;
  const test::BasisScene limited(builder.build("floor"), near), unlimited(builder.build("floor"), far);
  ASSERT_EQ(limited.hierarchy.size(), unlimited.hierarchy.size());
  std::size_t differ = 0;
  for (std::uint32_t point = 0; point < limited.hierarchy.size(); ++point) {
    EXPECT_LT(unlimited.hierarchy.radius(point), 1.5F);
    differ += limited.hierarchy.radius(point) != unlimited.hierarchy.radius(point) ? 1U : 0U;
  }
  EXPECT_LT(differ, limited.hierarchy.size() / 5U) << "points in corners alone reach further than four discs";
}

TEST(CoarsestShares, AreThoseOfTheArea) {
  // Many small blocks, each with samples of its own, in a room that holds nearly all area.
  const test::BasisScene scene(room_with_blocks(30), small_settings(1));
  double blocks = 0.0, whole = 0.0;
  for (std::uint32_t t = 0; t < scene.world.scene().triangles.size(); ++t) {
    const double area = static_cast<double>(scene.world.area(t));
    whole += area;
    if (scene.world.scene().triangle_object[t] != 0) blocks += area;
  }
  Task task;
  Hierarchy hierarchy = scene.hierarchy;
  Coefficients lit(hierarchy);
  std::size_t on_blocks = 0;
  for (std::uint32_t point = 0; point < hierarchy.size(); ++point) {
    const bool block = scene.world.scene().triangle_object[hierarchy.triangle(point)] != 0;
    on_blocks += block ? 1U : 0U;
    lit.set(point, Rgb(block ? 1.0F : 0.0F));
  }
  ASSERT_GT(static_cast<double>(on_blocks) / hierarchy.size(), 3.0 * blocks / whole);
  hierarchy.set_coarsest_shares(coarsest_shares(scene.world, scene.groups, hierarchy, task));
  EXPECT_NEAR(coarsest_mean(lit).r, blocks / whole, 0.1 * blocks / whole);
  double sum = 0.0;
  for (std::uint32_t point = 0; point < hierarchy.size(); ++point) sum += hierarchy.coarsest_share(point);
  EXPECT_NEAR(sum, 1.0, 1e-9);
}

}  // namespace
}  // namespace gibench::meshless
