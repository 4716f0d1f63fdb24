/// Links, what they sum to, what they cost, and the passes over the hierarchy whose cost must grow as n log n.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/antiradiance/accessibility.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/interreflection.h"
#include "methods/antiradiance/patch_transport.h"
#include "methods/antiradiance/refinement.h"

namespace gibench::antiradiance {
namespace {

Settings settings(std::vector<std::pair<std::string, std::string>> values) {
  return settings_from(Parameters(settings_schema(), values));
}

Scene empty_room() {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("white", Rgb(0.5F)), Vec3(0.0F), Vec3(1.0F));
  return builder.build("room");
}

Scene wall_and_ground() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("ground", white, {{{-1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {-1.0F, 0.0F, 0.0F}}});
  builder.quad("wall", white, {{{-20.0F, 0.0F, 0.0F}, {20.0F, 0.0F, 0.0F}, {20.0F, 20.0F, 0.0F}, {-20.0F, 20.0F, 0.0F}}});
  return builder.build("wall");
}

TEST(Links, OfAClosedRoomSumToOneEverywhere) {
  Task task;
  const World world(empty_room());
  const Settings rule = settings({{"elements", "1500"}});
  const Discretisation parts(world, rule, task);
  const Linking linking = make_linking(world, parts, rule, Visibility::none_needed, {}, task);
  std::vector<Rgb> ones(parts.hierarchy.leaf_count(), Rgb(1.0F)), sums(ones);
  PatchTransport(parts.hierarchy, linking.links).transport(ones, {}, sums, task);
  double squares = 0.0;
  for (const Rgb& sum : sums) {
    EXPECT_NEAR(sum.g, 1.0F, 0.1F);
    squares += std::pow(static_cast<double>(sum.g) - 1.0, 2.0);
  }
  EXPECT_LT(std::sqrt(squares / static_cast<double>(sums.size())), 0.02);
  const std::vector<float> closure = closure_factors(parts, linking, rule, task).factors;
  for (std::size_t i = 0; i < sums.size(); ++i) EXPECT_NEAR(sums[i].g * closure[i], 1.0F, 1e-5F);
}

TEST(Links, TenMillionFitInFourHundredMegabytes) {
  LinkTable table;
  table.senders.resize(10'000'000);
  table.factors.resize(table.senders.size());
  table.masks.resize(table.senders.size());
  EXPECT_LT(static_cast<double>(table.bytes()), 400e6);
}

TEST(Links, DoNotDependOnThreads) {
  const World world(made::box_scene());
  const Settings rule = settings({{"elements", "1000"}});
  std::vector<LinkTable> tables;
  for (const int threads : {1, 2}) {
    Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
    const Discretisation parts(world, rule, task);
    RefinementCounts counts;
    tables.push_back(make_links(parts.hierarchy, {Facing::both, 0.02F}, task, counts));
  }
  ASSERT_EQ(tables[0].size(), tables[1].size());
  EXPECT_EQ(tables[0].row_begin, tables[1].row_begin);
  EXPECT_EQ(tables[0].factors, tables[1].factors);
}

TEST(Links, BeyondTheBudgetGetCoarserOrAreRefused) {
  Task task;
  const World world(made::box_scene());
  const Settings wide = settings({{"elements", "2000"}}), narrow = settings({{"elements", "2000"}, {"memory_budget", "8"}}),
                 none = settings({{"elements", "2000"}, {"memory_budget", "1"}});
  const Discretisation parts(world, wide, task);
  const Linking free = make_linking(world, parts, wide, Visibility::none_needed, {}, task);
  const Linking bound = make_linking(world, parts, narrow, Visibility::none_needed, {}, task);
  EXPECT_TRUE(free.warning.empty());
  EXPECT_FALSE(bound.refused);
  EXPECT_LT(bound.links.size(), free.links.size());
  EXPECT_NE(bound.warning.find("tolerance"), std::string::npos);
  const Linking refused = make_linking(world, parts, none, Visibility::antiradiance, {}, task);
  EXPECT_TRUE(refused.refused);
  EXPECT_NE(refused.warning.find("memory_budget"), std::string::npos);
}

TEST(Links, RadiosityOracleSpendsLinksWhereLightIs) {
  Task task;
  const World world(made::box_scene());
  const Settings rule = settings({{"elements", "1000"}});
  const Discretisation parts(world, rule, task);
  std::vector<float> radiosity(parts.hierarchy.size(), 0.01F);
  // The floor.
  const auto is_bright = [&](const Node& node) { return node.sheet == 0; };
  for (std::size_t i = 0; i < radiosity.size(); ++i)
    if (is_bright(parts.hierarchy.nodes()[i])) radiosity[i] = 1.0F;
  RefinementCounts counts;
  RefinementRule geometry{Facing::fronts, 0.02F}, by_light = geometry;
  by_light.radiosity = radiosity;
  by_light.mean_radiosity = 0.2F;
  const LinkTable all = make_links(parts.hierarchy, geometry, task, counts),
                  some = make_links(parts.hierarchy, by_light, task, counts);
  const auto from_bright = [&](const LinkTable& table) {
    double count = 0.0;
    for (const Sender sender : table.senders)
      if (is_bright(parts.hierarchy.nodes()[sender.node()])) count += 1.0;
    return count / static_cast<double>(table.size());
  };
  EXPECT_GT(from_bright(some), 1.5 * from_bright(all));
}

TEST(Links, WhoseSumsDoNotConvergeAreReported) {
  const World world(made::box_scene());
  Task task;
  const Settings rule = settings({{"elements", "300"}, {"bins", "4"}, {"most_iterations", "1"}, {"residual", "1e-7"}});
  const Discretisation parts(world, rule, task);
  const Linking linking = make_linking(world, parts, rule, Visibility::antiradiance, {}, task);
  const Closure closure = closure_factors(parts, linking, rule, task);
  EXPECT_EQ(closure.termination, Termination::not_converged);
  EXPECT_TRUE(closure.factors.empty());
  EXPECT_NE(closure.message.find("most_iterations"), std::string::npos) << closure.message;
}

/// Tiles on a floor and on a ceiling, of one object, or an object each.
Scene tiles(int side, bool apart) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  std::vector<Vec3> corners;
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (int i = 0; i < 2 * side * side; ++i) {
    const int place = i / 2;
    const float x = static_cast<float>(place % side), z = static_cast<float>(place / side), s = 0.9F;
    const bool floor = i % 2 == 0;
    const float y = floor ? 0.0F : 4.0F;
    const Vec3 a(x, y, z), b(x, y, z + s), c(x + s, y, z + s), d(x + s, y, z);
    const std::array<Vec3, 4> tile = floor ? std::array{a, b, c, d} : std::array{a, d, c, b};
    if (apart) builder.quad("tile " + std::to_string(i), white, tile);
    const auto first = static_cast<std::uint32_t>(corners.size());
    corners.insert(corners.end(), tile.begin(), tile.end());
    faces.push_back({first, first + 1, first + 2, first + 3});
  }
  if (!apart) builder.object("tiles", white, corners, faces);
  return builder.build("tiles");
}

TEST(Links, CostAsMuchAmongManyObjectsAsInOne) {
  std::vector<double> pairs, blockers;
  for (const bool apart : {false, true}) {
    Task task;
    const World world(tiles(20, apart));
    const Settings rule = settings({{"elements", "100"}});
    const Discretisation parts(world, rule, task);
    EXPECT_LE(parts.hierarchy.roots().size(), 3U);
    RefinementCounts counts;
    make_links(parts.hierarchy, {Facing::both, 0.02F}, task, counts);
    pairs.push_back(static_cast<double>(counts.pairs));
    Accessibility accessibility(parts.elements, parts.hierarchy, 0.02F, 4);
    accessibility.compute(2, task);
    blockers.push_back(static_cast<double>(accessibility.evaluations()));
  }
  EXPECT_NEAR(pairs[1], pairs[0], 0.02 * pairs[0]);
  EXPECT_NEAR(blockers[1], blockers[0], 0.02 * blockers[0]);
}

TEST(Accessibility, IsAHalfAtTheFootOfATallWall) {
  Task task;
  const World world(wall_and_ground());
  const Discretisation parts(world, settings({{"elements", "2000"}}), task);
  for (const int passes : {1, 2, 3}) {
    Accessibility accessibility(parts.elements, parts.hierarchy, 0.02F);
    accessibility.compute(passes, task);
    EXPECT_NEAR(accessibility.at({0.0F, 1e-5F, 0.01F}, {0.0F, 1.0F, 0.0F}), 0.5F, 0.015F);
  }
}

TEST(Accessibility, HierarchyIsWithinTwoPerCentOfNaive) {
  Task task;
  const World world(made::box_scene());
  const Discretisation parts(world, settings({{"elements", "1500"}}), task);
  Accessibility fast(parts.elements, parts.hierarchy, 0.02F), naive(parts.elements, parts.hierarchy, 0.0F);
  fast.compute(2, task);
  naive.compute(2, task);
  for (const std::uint32_t element : parts.hierarchy.order()) {
    const Disc& disc = parts.elements.disc(element);
    EXPECT_NEAR(fast.at(disc.centre, disc.normal, element), naive.at(disc.centre, disc.normal, element), 0.02F);
  }
}

TEST(Accessibility, BlockersGrowAsNLogN) {
  Task task;
  const World world(made::box_scene());
  std::vector<double> cost, size;
  for (const char* count : {"500", "8000"}) {
    const Discretisation parts(world, settings({{"mode", "accessibility"}, {"elements", count}}), task);
    Accessibility fast(parts.elements, parts.hierarchy, 0.02F);
    fast.compute(2, task);
    size.push_back(std::log(static_cast<double>(parts.hierarchy.leaf_count())));
    cost.push_back(std::log(static_cast<double>(fast.evaluations())));
  }
  EXPECT_LT((cost.back() - cost.front()) / (size.back() - size.front()), 1.2);
}

}  // namespace
}  // namespace gibench::antiradiance
