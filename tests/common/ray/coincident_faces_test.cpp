#include "common/ray/coincident_faces.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"
#include "common/ray/coplanar_pairs.h"
#include "common/ray/world.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

using Quad = std::array<Vec3, 4>;

/// A square of this half edge in the plane y = height, its front up, or down.
Quad square(float half, float height, bool up = true) {
  const Vec3 a{-half, height, -half}, b{-half, height, half}, c{half, height, half}, d{half, height, -half};
  return up ? Quad{a, b, c, d} : Quad{d, c, b, a};
}

/// The other diagonal: the triangles of the two differ.
Quad turned(const Quad& quad) { return {quad[1], quad[2], quad[3], quad[0]}; }

struct Part {
  std::string name;
  Quad corners;
  Rgb emission;
  bool two_sided = false;
};

/// The parts in this order, or the other way round.
Scene sheets(std::vector<Part> parts, bool reversed = false) {
  if (reversed) std::reverse(parts.begin(), parts.end());
  made::SceneBuilder builder;
  for (const Part& part : parts)
    builder.quad(part.name, builder.diffuse(part.name, Rgb(0.5F), part.emission), part.corners, part.two_sided);
  return builder.build("sheets");
}

/// Names of the objects that vertical rays meet all over the square of this half edge, from above or from below.
std::set<std::string> met(const World& world, float half, bool from_above) {
  std::set<std::string> names;
  for (std::uint64_t i = 0; i < 500; ++i) {
    RandomStream random(3, 1, i);
    const float x = half * (2.0F * random.next_float() - 1.0F), z = half * (2.0F * random.next_float() - 1.0F);
    const float slope = 0.3F * (random.next_float() - 0.5F);
    const float side = from_above ? 1.0F : -1.0F;
    const Ray ray{Vec3(x - slope, side, z), 0.0F, {slope, -side, 0.0F}};
    const Hit hit = world.rays().closest_hit(ray);
    std::vector<Hit> batch(1);
    world.rays().closest_hits({&ray, 1}, batch);
    EXPECT_EQ(batch[0].triangle, hit.triangle);
    if (!hit) continue;
    const Vec3 position = world.position(hit.triangle, {hit.u, hit.v});
    EXPECT_NEAR(position.x, x, 1e-5F);
    EXPECT_NEAR(position.z, z, 1e-5F);
    names.insert(world.scene().objects[world.scene().triangle_object[hit.triangle]].name);
  }
  return names;
}

void expect_met(const std::vector<Part>& parts, float half, const std::string& above, const std::string& below) {
  for (const bool reversed : {false, true}) {
    const World world(sheets(parts, reversed));
    EXPECT_THAT(met(world, half, true), testing::ElementsAre(above)) << reversed;
    EXPECT_THAT(met(world, half, false), testing::ElementsAre(below)) << reversed;
  }
}

TEST(CoincidentFaces, BothSidesModelledAreATwoSidedPairInAnyOrder) {
  for (const auto& other : {square(1.0F, 0.0F, false), turned(square(1.0F, 0.0F, false))})
    expect_met({{"up", square(1.0F, 0.0F), Rgb()}, {"down", other, Rgb()}}, 1.0F, "up", "down");
}

TEST(CoincidentFaces, AnEmitterIsInFrontOfWhatReflects) {
  expect_met({{"lamp", square(0.5F, 0.0F, false), Rgb(3.0F)}, {"ceiling", square(2.0F, 0.0F, false), Rgb()}}, 0.49F, "lamp",
             "lamp");
  // Even of one with more area.
  expect_met({{"lamp", square(2.0F, 0.0F), Rgb(3.0F)}, {"rug", square(0.5F, 0.0F), Rgb()}}, 0.49F, "lamp", "lamp");
}

TEST(CoincidentFaces, TheSmallerLiesOnTheLarger) {
  expect_met({{"floor", square(2.0F, 0.0F), Rgb()}, {"rug", turned(square(0.5F, 0.0F)), Rgb()}}, 0.49F, "rug", "rug");
}

TEST(CoincidentFaces, EqualFacesGoByTheirNames) {
  expect_met({{"b", square(1.0F, 0.0F), Rgb()}, {"a", square(1.0F, 0.0F), Rgb()}}, 1.0F, "a", "a");
}

TEST(CoincidentFaces, ABlackBackIsBehindAnyLitSide) {
  expect_met({{"lamp", square(1.0F, 0.0F), Rgb(3.0F)}, {"sheet", square(1.0F, 0.0F), Rgb(), true}}, 1.0F, "lamp", "sheet");
}

TEST(CoincidentFaces, AMillimetreIsToldApart) {
  for (const bool reversed : {false, true}) {
    const World world(sheets({{"floor", square(2.0F, 0.0F), Rgb()}, {"lamp", square(0.5F, -1e-3F), Rgb(1.0F)}}, reversed));
    EXPECT_TRUE(world.coincident().empty());
    EXPECT_THAT(met(world, 0.49F, true), testing::ElementsAre("floor"));
  }
}

TEST(CoincidentFaces, NeighboursAndCrossingSheetsAreNoPairs) {
  // A lattice of coplanar quads, tilted so that its corners are rounded, and a box.
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const auto place = [](int i, int j) { return Vec3(0.1F * static_cast<float>(i), 0.0F, 0.1F * static_cast<float>(j)); };
  for (int i = 0; i < 30; ++i)
    for (int j = 0; j < 30; ++j)
      builder.quad("q" + std::to_string(30 * i + j), white, {place(i, j), place(i, j + 1), place(i + 1, j + 1), place(i + 1, j)});
  for (const float degrees : {0.0F, 17.0F, 73.0F}) {
    const Scene scene = made::transformed(builder.build("lattice"), 3.7F, {0.3F, 0.5F, 0.8F}, degrees, Vec3(40.0F, 3.0F, 9.0F));
    EXPECT_TRUE(coplanar_pairs(scene.vertices, scene.triangles, 2).empty()) << degrees;
  }
  made::BoxOptions empty;
  empty.blocks = false;
  const Scene box = made::box_scene(empty);
  EXPECT_TRUE(coplanar_pairs(box.vertices, box.triangles, 2).empty());
  const Scene crossing = made::random_triangles(2000, 1.0F, 0.2F, 5);
  EXPECT_TRUE(coplanar_pairs(crossing.vertices, crossing.triangles, 2).empty());
}

TEST(CoincidentFaces, AreFoundWhereverTheSceneLiesAndCounted) {
  const Scene scene = sheets({{"a", square(1.0F, 0.0F), Rgb()},
                              {"b", square(1.0F, 0.0F), Rgb()},
                              {"c", square(1.0F, 0.0F, false), Rgb()},
                              {"rug", square(0.25F, 0.0F), Rgb()}});
  for (const float degrees : {0.0F, 17.0F, 73.0F}) {
    const Scene moved = made::transformed(scene, 3.7F, {0.3F, 0.5F, 0.8F}, degrees, Vec3(40.0F, 3.0F, 9.0F));
    const std::vector<CoplanarPair> pairs = coplanar_pairs(moved.vertices, moved.triangles, 1);
    const CoincidenceCounts counts = count_coincidences(pairs);
    EXPECT_EQ(counts.twins, 2U);
    EXPECT_EQ(counts.opposite_twins + counts.overlaps, pairs.size() - 2);
    const std::vector<CoplanarPair> again = coplanar_pairs(moved.vertices, moved.triangles, 2);
    ASSERT_EQ(again.size(), pairs.size());
    for (std::size_t i = 0; i < pairs.size(); ++i) EXPECT_TRUE(again[i].a == pairs[i].a && again[i].b == pairs[i].b);
  }
}

TEST(CoincidentFaces, ABlockStandsOnTheFloorItCovers) {
  const World world(made::box_scene());
  std::set<std::string> names;
  for (const CoplanarPair& pair : world.geometry().coplanar()) {
    EXPECT_FALSE(pair.same_winding);
    EXPECT_FALSE(pair.same_corners);
    for (const std::uint32_t triangle : {pair.a, pair.b})
      names.insert(world.scene().objects[world.scene().triangle_object[triangle]].name);
  }
  EXPECT_THAT(names, testing::ElementsAre("floor", "short", "tall"));
}

TEST(CoincidentFaces, OfOneWindingCountOnce) {
  const World world(sheets({{"a", square(1.0F, 0.0F), Rgb()}, {"b", square(1.0F, 0.0F), Rgb()}}));
  EXPECT_DOUBLE_EQ(world.total_area(), 4.0);
  EXPECT_EQ(world.area(0) + world.area(1) + world.area(2) + world.area(3), 4.0F);
  const World pair(sheets({{"a", square(1.0F, 0.0F), Rgb()}, {"b", square(1.0F, 0.0F, false), Rgb()}}));
  EXPECT_DOUBLE_EQ(pair.total_area(), 8.0);
}

TEST(CoincidentFaces, SurfaceSamplesLieWhereRaysMeetThem) {
  const World world(sheets({{"floor", square(1.0F, 0.0F), Rgb()}, {"rug", square(0.5F, 0.0F), Rgb()}}));
  const std::vector<SurfaceSample> samples = area_uniform_samples(world, 4000, 1);
  ASSERT_EQ(samples.size(), 4000U);
  std::size_t on_rug = 0;
  for (const SurfaceSample& sample : samples) {
    const bool inside = max_abs(sample.position) < 0.5F;
    EXPECT_EQ(world.scene().objects[sample.object].name, inside ? "rug" : "floor");
    on_rug += inside ? 1 : 0;
  }
  // A quarter of the shown area: binomial, four standard deviations and the stratification's gain unused.
  EXPECT_NEAR(static_cast<double>(on_rug), 1000.0, 4.0 * std::sqrt(4000.0 * 0.25 * 0.75));
}

}  // namespace
}  // namespace gibench
