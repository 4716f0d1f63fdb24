/// Elements: their areas and quadtrees, the leaf at a point, faces cut where others stand on them.
#include "methods/wavelet/elements.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "common/geometry/surface_sampling.h"
#include "methods/wavelet/flat_pieces.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace wavelet;

double area_of(const Elements& elements) {
  double area = 0.0;
  for (const Element& element : elements.elements()) area += static_cast<double>(elements.nodes()[element.root].area);
  return area;
}

TEST(WaveletElements, CoverTheLitSidesAndFindTheLeafOfEachPoint) {
  const World world(open_corner(), 1);
  Task task;
  const Elements elements(world, {0.01, true, 4}, task);
  double area = world.total_area();
  for (std::uint32_t t = 0; t < world.scene().triangles.size(); ++t)
    if (world.scene().objects[world.scene().triangle_object[t]].two_sided) area += static_cast<double>(world.area(t));
  EXPECT_NEAR(area_of(elements), area, 1e-4 * area);
  for (const Node& node : elements.nodes()) {
    if (node.is_leaf()) continue;
    float sum = 0.0F;
    for (std::size_t c = 0; c < child_count; ++c) sum += elements.nodes()[node.first_child + c].area;
    EXPECT_NEAR(sum, node.area, 1e-5F * node.area);
  }
  for (const SurfaceSample& sample : area_uniform_samples(world, 500, 7)) {
    const std::uint32_t leaf = elements.leaf_at(world, sample);
    ASSERT_NE(leaf, none);
    const Patch& patch = elements.nodes()[leaf].patch;
    EXPECT_GT(glm::dot(elements.element_of(leaf).normal, sample.normal), 0.99F);
    EXPECT_LE(glm::length(patch.middle() - sample.position), 1.001F * patch.radius());
  }
}

/// A room with a block on its floor.
World room_with_block() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.block("block", white, {0.3F, 0.0F, 0.4F}, {0.6F, 0.5F, 0.8F}, 20.0F);
  return World(builder.build("room with a block"), 1);
}

TEST(WaveletElements, LeaveOutWhatIsCovered) {
  const World world = room_with_block();
  Task task;
  const Elements elements(world, {0.004, true, 4}, task);
  // The room without the block's footprint; of the block all, since its underside looks out of the room.
  EXPECT_NEAR(area_of(elements), 6.0 - 0.12 + (2.0 * 0.12 + 2.0 * (0.3 + 0.4) * 0.5), 0.005);
  // Where faces are cut every leaf is covered or open as a whole, but for what lies within a hair of the cut.
  for (const std::uint32_t leaf : elements.leaves()) {
    const float share = elements.nodes()[leaf].area / elements.nodes()[leaf].patch.area();
    EXPECT_TRUE(share < 0.01F || share > 0.99F) << share;
  }
}

TEST(WaveletElements, CutFacesKeepTheirArea) {
  const World world = room_with_block();
  for (const bool cuts : {false, true}) {
    double area = 0.0;
    for (const FlatPiece& piece : flat_pieces(world, cuts).pieces) {
      area += static_cast<double>(piece.patch.area());
      EXPECT_NEAR(glm::dot(glm::normalize(piece.patch.area_vector()), piece.normal), 1.0F, 1e-4F);
    }
    EXPECT_NEAR(area, world.total_area(), 1e-4 * world.total_area());
  }
  EXPECT_GT(flat_pieces(world, true).pieces.size(), flat_pieces(world, false).pieces.size());
}

TEST(WaveletElements, OddQuadsAreTakenByTriangleAndCounted) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  const auto quad = [&](const char* name, const std::array<Vec3, 4>& corners) { builder.quad(name, white, corners); };
  quad("flat", {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  quad("bent", {{{2, 0, 0}, {3, 0, 0}, {3, 1, 0.5F}, {2, 1, 0}}});
  quad("concave", {{{4, 0, 0}, {5, 0, 0}, {4.2F, 0.2F, 0}, {4, 1, 0}}});
  quad("bow tie", {{{6, 0, 0}, {7, 1, 0}, {7, 0, 0}, {6, 1, 0}}});
  quad("line", {{{8, 0, 0}, {8.5F, 0, 0}, {9, 0, 0}, {8.2F, 0, 0}}});
  const World world(builder.build("odd quads"), 1);
  const FlatPieces flat = flat_pieces(world, true);
  EXPECT_EQ(flat.quads_by_triangle, 4U);
  EXPECT_EQ(flat.faces_without_area, 2U);
  Task task;
  const Elements elements(world, {0.05, true, 4}, task);
  EXPECT_EQ(task.counters()["quads_by_triangle"], 4U);
  for (const Node& node : elements.nodes()) EXPECT_TRUE(std::isfinite(node.area));
}

TEST(WaveletElements, MoreThanAllowedAreRefused) {
  const World world(open_corner());
  Task task;
  EXPECT_EQ(Elements(world, {0.02, true, 0}, task).refused(), 0U);
  const Elements refused(world, {0.02, true, 0, 3}, task);
  EXPECT_GT(refused.refused(), 3U);
  EXPECT_TRUE(refused.elements().empty());
}

}  // namespace
}  // namespace gibench::test
