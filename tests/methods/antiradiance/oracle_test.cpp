/// The oracle of eight lanes against what each pair gives by itself, and the rows that it fills.
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/refinement.h"

namespace gibench::antiradiance {
namespace {

Discretisation discretised(const World& world, const char* elements, Task& task) {
  return {world, settings_from(Parameters(settings_schema(), {{"elements", elements}})), task};
}

/// The form factor of two nodes as discs, by numbers instead of lanes.
float factor_of(const Node& p, const Node& q) {
  const Vec3 d = q.centre - p.centre;
  const float squared = glm::dot(d, d), r = std::sqrt(squared), s = pi * squared + p.area + q.area;
  const float u = glm::dot(p.normal, d), v = -glm::dot(q.normal, d), m = glm::dot(p.normal, q.normal);
  const float facing = (u < 0.0F) != (v < 0.0F) ? -m : m;
  return coaxial_exchange(squared, p.area, q.area) *
         orientation_factor(std::fabs(u) / r, std::fabs(v) / r, facing, p.area / s, q.area / s) / p.area;
}

TEST(Oracle, GivesLinksTheFormFactorOfTheirDiscs) {
  Task task;
  const World world(made::box_scene());
  const Discretisation parts = discretised(world, "700", task);
  const auto nodes = parts.hierarchy.nodes();
  for (const Facing facing : {Facing::fronts, Facing::both}) {
    RefinementCounts counts;
    const LinkTable table = make_links(parts.hierarchy, {facing, 0.02F}, task, counts);
    ASSERT_GT(table.size(), 10'000U);
    EXPECT_GT(counts.pairs, table.size());
    for (std::uint32_t p = 0; p < nodes.size(); ++p)
      for (std::uint32_t link = table.row_begin[p]; link < table.row_begin[p + 1]; ++link) {
        const Sender sender = table.senders[link];
        const Node& q = nodes[sender.node()];
        const Vec3 d = q.centre - nodes[p].centre;
        ASSERT_EQ(sender.to_back(), glm::dot(nodes[p].normal, d) < 0.0F);
        ASSERT_EQ(sender.from_back(), glm::dot(q.normal, d) > 0.0F);
        // The two cosines are sums of products of about one: eight roundings of what the factor would be without them.
        const float rounding = 8.0F * 0x1p-24F * coaxial_exchange(glm::dot(d, d), nodes[p].area, q.area) / nodes[p].area;
        ASSERT_NEAR(table.factors[link], factor_of(nodes[p], q), 1e-5F * table.factors[link] + rounding);
      }
  }
}

TEST(Oracle, LinksEveryPairOfElementsOnceOrNotAtAll) {
  Task task;
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("white", Rgb(0.5F)), Vec3(0.0F), Vec3(1.0F));
  const World world(builder.build("room"));
  const Discretisation parts = discretised(world, "500", task);
  const auto nodes = parts.hierarchy.nodes();
  const std::size_t leaves = parts.hierarchy.leaf_count();
  RefinementCounts counts;
  const LinkTable table = make_links(parts.hierarchy, {Facing::fronts, 0.02F}, task, counts);
  std::vector<int> covered(leaves * leaves, 0);
  for (std::uint32_t p = 0; p < nodes.size(); ++p)
    for (std::uint32_t link = table.row_begin[p]; link < table.row_begin[p + 1]; ++link) {
      const Node& q = nodes[table.senders[link].node()];
      for (std::size_t i = nodes[p].begin; i < nodes[p].end; ++i)
        for (std::size_t j = q.begin; j < q.end; ++j) ++covered[i * leaves + j];
    }
  double facing = 0.0, linked = 0.0;
  for (std::size_t i = 0; i < leaves; ++i)
    for (std::size_t j = 0; j < leaves; ++j) {
      ASSERT_LE(covered[i * leaves + j], 1);
      const Node &p = nodes[parts.hierarchy.leaf_node(i)], &q = nodes[parts.hierarchy.leaf_node(j)];
      if (glm::dot(p.normal, q.normal) > 0.99F) continue;  // of one wall
      facing += 1.0, linked += covered[i * leaves + j];
    }
  // A pair of bent nodes whose middles look away from each other is dropped when it is too little to be split.
  EXPECT_GT(linked / facing, 0.99);
}

}  // namespace
}  // namespace gibench::antiradiance
