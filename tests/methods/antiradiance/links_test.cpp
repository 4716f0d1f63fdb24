/// Links, what they sum to, what they cost, and the passes over the hierarchy whose cost must grow as n log n.
#include <gtest/gtest.h>

#include <cmath>
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
  const std::uint32_t bright = parts.hierarchy.roots()[0];
  for (std::size_t i = bright; i < bright + 2 * (parts.hierarchy.nodes()[bright].end - parts.hierarchy.nodes()[bright].begin) - 1;
       ++i)
    radiosity[i] = 1.0F;
  RefinementCounts counts;
  RefinementRule geometry{Facing::fronts, 0.02F}, by_light = geometry;
  by_light.radiosity = radiosity;
  by_light.mean_radiosity = 0.2F;
  const LinkTable all = make_links(parts.hierarchy, geometry, task, counts),
                  some = make_links(parts.hierarchy, by_light, task, counts);
  const auto from_bright = [&](const LinkTable& table) {
    double count = 0.0;
    for (const Sender sender : table.senders)
      if (parts.hierarchy.nodes()[sender.node()].begin < parts.hierarchy.nodes()[bright].end) count += 1.0;
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
  for (std::size_t i = 0; i < parts.hierarchy.leaf_count(); ++i)
    EXPECT_NEAR(fast.of_side(i, true), naive.of_side(i, true), 0.02F);
}

TEST(Accessibility, BlockersGrowAsNLogN) {
  Task task;
  const World world(made::box_scene());
  std::vector<double> cost, size;
  for (const char* count : {"500", "8000"}) {
    const Discretisation parts(world, settings({{"elements", count}}), task);
    Accessibility fast(parts.elements, parts.hierarchy, 0.02F);
    fast.compute(2, task);
    size.push_back(std::log(static_cast<double>(parts.hierarchy.leaf_count())));
    cost.push_back(std::log(static_cast<double>(fast.evaluations())));
  }
  EXPECT_LT((cost.back() - cost.front()) / (size.back() - size.front()), 1.2);
}

}  // namespace
}  // namespace gibench::antiradiance
