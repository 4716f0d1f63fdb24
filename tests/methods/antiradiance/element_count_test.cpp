/// How many elements a scene needs: by its shape, not by how finely its faces are cut.
#include "methods/antiradiance/element_count.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "common/scene/made_scenes.h"

namespace gibench::antiradiance {
namespace {

std::size_t corners_of(Scene scene, double edge_length) {
  const World world(std::move(scene));
  return corner_count(SamplingMesh(world, {edge_length, 40.0F, true}));
}

TEST(ElementCount, CornersDoNotGrowWithTheFaces) {
  made::SceneBuilder builder;
  builder.block("block", builder.diffuse("white", Rgb(0.5F)), Vec3(0.0F), {1.0F, 2.0F, 3.0F});
  const Scene block = builder.build("block");
  for (const double edge : {10.0, 0.5, 0.1}) EXPECT_EQ(corners_of(block, edge), 24U) << edge;
}

TEST(ElementCount, BentSurfacesHaveACornerAtEveryVertex) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  std::vector<Vec3> rim;
  std::vector<std::array<std::uint32_t, 4>> faces;
  constexpr std::uint32_t sides = 40;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const float angle = 2.0F * pi * static_cast<float>(i) / static_cast<float>(sides);
    for (const float y : {0.0F, 1.0F}) rim.push_back({std::cos(angle), y, std::sin(angle)});
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    faces.push_back({a, a + 1, b + 1, b});
  }
  builder.object("tube", white, rim, faces);
  EXPECT_EQ(corners_of(builder.build("tube"), 10.0), 2 * sides);
}

TEST(ElementCount, IsThatOfARoomOrTheMeanOfThatAndTheCorners) {
  EXPECT_EQ(elements_for(0), elements_of_a_room);
  EXPECT_EQ(elements_for(4096), elements_of_a_room);
  EXPECT_EQ(elements_for(4 * 4096), 2 * elements_of_a_room);
  EXPECT_EQ(elements_for(100 * 4096), 10 * elements_of_a_room);
}

}  // namespace
}  // namespace gibench::antiradiance
