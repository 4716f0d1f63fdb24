#include "common/spaces/side_cells.h"

#include <gtest/gtest.h>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

/// A large wall, a small one that is two-sided, and a sliver.
Scene walls() {
  made::SceneBuilder builder;
  const auto white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("large", white, {Vec3(0, 0, 0), Vec3(9, 0, 0), Vec3(9, 9, 0), Vec3(0, 9, 0)});
  builder.quad("small", white, {Vec3(0, 0, 1), Vec3(0.1F, 0, 1), Vec3(0.1F, 0.1F, 1), Vec3(0, 0.1F, 1)}, true);
  builder.quad("none", white, {Vec3(0, 0, 2), Vec3(1, 0, 2), Vec3(2, 0, 2), Vec3(3, 0, 2)});
  return builder.build("walls");
}

TEST(SideCells, APointOfACellLiesInIt) {
  const World world(walls(), 1);
  const SideCells cells(world, CellSides::all, 500);
  RandomStream random(1, 2, 3);
  for (std::uint32_t cell = 0; cell < cells.size(); ++cell)
    for (int i = 0; i < 20; ++i) {
      const float u = random.next_float(), v = random.next_float();
      const Vec2 place = cells.barycentrics(cell, Vec2(0.01F) + 0.97F * uniform_triangle({u, v}));
      ASSERT_EQ(cells.at(cells.triangle(cell), cells.front(cell), place), cell);
    }
}

TEST(SideCells, CornersAndEdgesBelongToTheSide) {
  const World world(walls(), 1);
  const SideCells cells(world, CellSides::lit, 500);
  for (const Vec2 place : {Vec2(0, 0), Vec2(1, 0), Vec2(0, 1), Vec2(0.5F, 0.5F), Vec2(1.0001F, -0.0001F)}) {
    const std::uint32_t cell = cells.at(0, true, place);
    EXPECT_GE(cell, cells.begin(0));
    EXPECT_LT(cell, cells.end(0));
  }
}

TEST(SideCells, LargeSidesHaveMoreOfThem) {
  const World world(walls(), 1);
  const SideCells cells(world, CellSides::lit, 500);
  EXPECT_NEAR(static_cast<double>(cells.end(0) - cells.begin(0)), 250.0, 16.0);  // a whole number of rows: 15² or 16²
  double area = 0.0;
  for (std::uint32_t cell = cells.begin(0); cell < cells.end(0); ++cell) area += static_cast<double>(cells.area(cell));
  EXPECT_NEAR(area, 40.5, 1e-3);
  for (std::uint32_t triangle = 2; triangle < 4; ++triangle)
    for (const bool front : {true, false}) {
      const std::uint32_t side = SideCells::side_number(triangle, front);
      EXPECT_EQ(cells.end(side) - cells.begin(side), 1U);
    }
}

TEST(SideCells, BlackBacksAndWhatHasNoAreaHaveNone) {
  const World world(walls(), 1);
  const SideCells lit(world, CellSides::lit, 500), all(world, CellSides::all, 500);
  EXPECT_EQ(lit.at(0, false, {0.2F, 0.2F}), SideCells::none);
  EXPECT_NE(all.at(0, false, {0.2F, 0.2F}), SideCells::none);
  EXPECT_NE(lit.at(2, false, {0.2F, 0.2F}), SideCells::none);
  for (std::uint32_t triangle = 4; triangle < 6; ++triangle) EXPECT_EQ(all.at(triangle, true, {0.2F, 0.2F}), SideCells::none);
}

}  // namespace
}  // namespace gibench
