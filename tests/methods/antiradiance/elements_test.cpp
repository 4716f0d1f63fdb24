/// Elements and their hierarchy: areas, bounds, and what bad geometry does to them.
#include "methods/antiradiance/elements.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "common/scene/made_scenes.h"
#include "methods/antiradiance/hierarchy.h"

namespace gibench::antiradiance {
namespace {

struct Made {
  explicit Made(Scene scene, double edge_length, int threads = 2)
      : world(std::move(scene)),
        task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}}),
        mesh(world, {edge_length, 40.0F, true}),
        elements(world, mesh, 16, {64, true}, task),
        hierarchy(elements, {}, task) {}
  World world;
  Task task;
  SamplingMesh mesh;
  Elements elements;
  Hierarchy hierarchy;
};

Scene closed_block() {
  made::SceneBuilder builder;
  builder.block("block", builder.diffuse("white", Rgb(0.5F)), Vec3(0.0F), {1.0F, 2.0F, 3.0F});
  return builder.build("block");
}

TEST(Elements, AreasSumToTheScenes) {
  for (const double edge : {10.0, 0.3, 0.1}) {
    const Made made(made::box_scene(), edge);
    EXPECT_NEAR(made.elements.area(), made.world.total_area(), 1e-5 * made.world.total_area());
  }
}

TEST(Elements, HaveAQuarterOfAQuadAndAThirdOfATriangle) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("quad", white, {{{0.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}, {2.0F, 0.0F, -2.0F}, {0.0F, 0.0F, -2.0F}}});
  builder.object("triangle", white, {{5.0F, 0.0F, 0.0F}, {8.0F, 0.0F, 0.0F}, {5.0F, 0.0F, -2.0F}}, {{0, 1, 2, 2}});
  const Made made(builder.build("faces"), 100.0);
  ASSERT_EQ(made.elements.size(), 7U);
  for (std::uint32_t i = 0; i < 7; ++i) EXPECT_NEAR(made.elements.disc(i).area, 1.0F, 1e-5F);
}

TEST(Elements, SplitVerticesAtCreases) {
  const Made made(closed_block(), 100.0);
  EXPECT_EQ(made.elements.size(), 24U);
  for (std::uint32_t i = 0; i < made.elements.size(); ++i)
    EXPECT_NEAR(std::max({std::fabs(made.elements.disc(i).normal.x), std::fabs(made.elements.disc(i).normal.y),
                          std::fabs(made.elements.disc(i).normal.z)}),
                1.0F, 1e-5F);
}

TEST(Elements, InsideGeometryTakeNoPart) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, Vec3(0.0F), Vec3(4.0F));
  builder.block("block", white, {1.0F, 0.0F, 1.0F}, {3.0F, 1.0F, 3.0F});
  const Made made(builder.build("covered floor"), 0.25);
  double exposed = 0.0;
  for (std::uint32_t i = 0; i < made.elements.size(); ++i)
    if (made.elements.sheet(i) == 0 && made.elements.disc(i).normal.y > 0.5F)
      exposed += static_cast<double>(made.elements.disc(i).area);
  // 16 points per cell: the covered share is known to within one sixteenth of the cells along the block's foot.
  EXPECT_NEAR(exposed, 16.0 - 4.0, 32.0 * 0.0625 / 16.0 + 0.02);
}

TEST(Elements, BehindACoplanarFaceTakeNoPart) {
  for (const bool rug_first : {true, false}) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
    const auto square = [&](const std::string& name, float low, float high) {
      builder.quad(name, white, {{{low, 0.0F, low}, {low, 0.0F, high}, {high, 0.0F, high}, {high, 0.0F, low}}});
    };
    if (rug_first) square("rug", 1.0F, 3.0F);
    square("floor", 0.0F, 4.0F);
    if (!rug_first) square("rug", 1.0F, 3.0F);
    const Made made(builder.build("rug in a floor's plane"), 0.25);
    const std::uint32_t floor = rug_first ? 2 : 0;
    double of_floor = 0.0, of_rug = 0.0;
    for (std::uint32_t i = 0; i < made.elements.size(); ++i) {
      const Disc& disc = made.elements.disc(i);
      (made.elements.sheet(i) == floor ? of_floor : of_rug) += static_cast<double>(disc.area);
      if (made.elements.sheet(i) != floor || !(disc.area > 0.0F)) continue;
      EXPECT_FALSE(disc.centre.x > 1.0F && disc.centre.x < 3.0F && disc.centre.z > 1.0F && disc.centre.z < 3.0F);
    }
    // 16 points per cell, as below a block's foot.
    EXPECT_NEAR(of_floor, 16.0 - 4.0, 32.0 * 0.0625 / 16.0 + 0.02) << rug_first;
    EXPECT_NEAR(of_rug, 4.0, 1e-4) << rug_first;
  }
}

/// Nothing is closed there: a twentieth of what the second sheet's middle could see is open on all sides.
TEST(Elements, BehindTheBackOfASheetAreNotInsideGeometry) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  for (const float y : {1.0F, 1.5F})
    builder.quad("facing down", white, {{{-2.0F, y, -2.0F}, {2.0F, y, -2.0F}, {2.0F, y, 2.0F}, {-2.0F, y, 2.0F}}});
  const Made made(builder.build("two sheets"), 0.5);
  for (std::uint32_t i = 0; i < made.elements.size(); ++i) EXPECT_EQ(made.elements.exposed_share(i), 1.0F) << i;
}

/// A room that a sheet parts at this height; its back is black.
Scene parted_room(float height) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.quad("sheet", white, {{{0.0F, height, 0.0F}, {0.0F, height, 1.0F}, {1.0F, height, 1.0F}, {1.0F, height, 0.0F}}});
  return builder.build("parted room");
}

TEST(Elements, ThatASurfaceCrossesStandForOneSideOfIt) {
  const float height = 0.53F;
  const Made made(parted_room(height), 0.1);
  std::size_t parted = 0;
  for (std::uint32_t i = 0; i < made.elements.size(); ++i) {
    bool above = false, below = false;
    for (const CellPoint& point : made.elements.points(i)) {
      if (!point.exposed || std::fabs(point.normal.y) > 0.5F) continue;
      (point.origin.y > height ? above : below) = true;
    }
    EXPECT_FALSE(above && below) << i;
    if (made.elements.parted(i)) ++parted;
  }
  // The four walls have eleven vertices along the sheet.
  EXPECT_GE(parted, 40U);
}

TEST(Elements, OnThinSlabsAreKnown) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.block("slab", white, Vec3(0.0F), {1.0F, 0.01F, 1.0F});
  builder.block("block", white, {3.0F, 0.0F, 0.0F}, {4.0F, 1.0F, 1.0F});
  const Made made(builder.build("slab and block"), 0.2);
  for (std::uint32_t i = 0; i < made.elements.size(); ++i) {
    const bool of_slab = made.elements.sheet(i) == 0, broad = std::fabs(made.elements.disc(i).normal.y) > 0.5F;
    if (of_slab && broad) {
      EXPECT_TRUE(made.elements.backed(i)) << i;
    }
    if (!of_slab) {
      EXPECT_FALSE(made.elements.backed(i)) << i;
    }
  }
}

/// A chain that turns right at every node: a tree as deep as it can be.
TEST(Hierarchy, TreesOfAnyDepthAreVisitedToTheirLeaves) {
  constexpr std::uint32_t leaves = 1000;
  std::vector<Node> nodes;
  for (std::uint32_t depth = 0; depth + 1 < leaves; ++depth) {
    Node inner, leaf;
    inner.begin = depth, inner.end = leaves, inner.right = static_cast<std::uint32_t>(nodes.size()) + 2;
    leaf.begin = depth, leaf.end = depth + 1;
    nodes.push_back(inner);
    nodes.push_back(leaf);
  }
  Node last;
  last.begin = leaves - 1, last.end = leaves;
  nodes.push_back(last);
  std::uint32_t met = 0, visited = 0;
  visit_down(nodes, 0, [&](std::uint32_t node) {
    ++visited;
    if (nodes[node].is_leaf()) {
      EXPECT_EQ(nodes[node].begin, met++);
    }
    return true;
  });
  EXPECT_EQ(met, leaves);
  EXPECT_EQ(visited, nodes.size());
  visited = 0;
  visit_down(nodes, 0, [&](std::uint32_t node) { return ++visited, nodes[node].begin < 10; });
  EXPECT_EQ(visited, 21U);  // ten inner nodes that were opened, their leaves, and the next inner node
}

TEST(Hierarchy, DrawsLeavesByArea) {
  const Made made(made::box_scene(), 0.2);
  constexpr int draws = 100'000;
  const std::uint32_t root = made.hierarchy.roots()[0];
  std::vector<double> drawn(made.hierarchy.leaf_count(), 0.0);
  for (int i = 0; i < draws; ++i)
    drawn[made.hierarchy.leaf_by_area(root, (static_cast<float>(i) + 0.5F) / draws).begin] += 1.0 / draws;
  const Node& whole = made.hierarchy.nodes()[root];
  for (std::uint32_t leaf = whole.begin; leaf < whole.end; ++leaf) {
    const float area = made.hierarchy.nodes()[made.hierarchy.leaf_node(leaf)].area;
    EXPECT_NEAR(drawn[leaf], static_cast<double>(area / whole.area), 2.0 / draws + 1e-5) << leaf;
  }
}

TEST(Hierarchy, BoundsItsElements) {
  const Made made(made::box_scene(), 0.08);
  for (const Node& node : made.hierarchy.nodes()) {
    double area = 0.0;
    for (std::uint32_t leaf = node.begin; leaf < node.end; ++leaf) {
      const Disc& disc = made.elements.disc(made.hierarchy.order()[leaf]);
      area += static_cast<double>(disc.area);
      const Vec3 offset = disc.centre - node.centre;
      EXPECT_LE(glm::length(offset), node.reach * 1.0001F + 1e-6F);
      EXPECT_LE(std::fabs(glm::dot(offset, node.normal)), node.thickness * 1.0001F + 1e-5F);
      if (node.cone_sine < 1.0F) {
        EXPECT_GT(glm::dot(disc.normal, node.normal), 0.0F);
        EXPECT_LE(glm::length(glm::cross(disc.normal, node.normal)), node.cone_sine + 1e-4F);
      }
    }
    EXPECT_NEAR(static_cast<double>(node.area), area, 1e-4 * area);
  }
}

TEST(Hierarchy, IsTheSameForAnyNumberOfThreads) {
  const Made one(made::box_scene(), 0.08, 1), two(made::box_scene(), 0.08, 2);
  ASSERT_EQ(one.hierarchy.size(), two.hierarchy.size());
  EXPECT_TRUE(std::equal(one.hierarchy.order().begin(), one.hierarchy.order().end(), two.hierarchy.order().begin()));
  for (std::size_t i = 0; i < one.hierarchy.size(); ++i)
    EXPECT_EQ(one.hierarchy.nodes()[i].centre, two.hierarchy.nodes()[i].centre);
}

TEST(Elements, LiveWithBadGeometry) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  // Zero area, duplicate vertices, two faces of opposite orientation, one that lies in another.
  builder.object("bad", white,
                 {{0.0F, 0.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {1.0F, 0.0F, -1.0F}, {0.0F, 0.0F, 0.0F}, {0.0F, 0.0F, -1.0F}},
                 {{0, 1, 1, 1}, {0, 1, 2, 2}, {2, 3, 4, 4}, {0, 2, 4, 4}, {3, 1, 2, 2}});
  const Made made(builder.build("bad"), 0.5);
  EXPECT_GT(made.elements.size(), 0U);
  for (std::uint32_t i = 0; i < made.elements.size(); ++i) {
    EXPECT_TRUE(is_finite(made.elements.disc(i).centre));
    EXPECT_TRUE(is_finite(made.elements.disc(i).normal));
    EXPECT_TRUE(std::isfinite(made.elements.disc(i).area));
  }
}

}  // namespace
}  // namespace gibench::antiradiance
