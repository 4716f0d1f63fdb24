#include "common/ray/world.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/core/parallel.h"
#include "common/core/random.h"
#include "common/scene/made_scenes.h"
#include "common/scene/tessellate.h"

namespace gibench {
namespace {

constexpr std::size_t ray_count = 200'000;

/// A point on a random triangle (uniform within it) and a cosine-distributed direction on its front.
struct SurfaceRay {
  SurfaceSample sample;
  Ray ray;
};

SurfaceRay surface_ray(const World& world, std::uint64_t index) {
  RandomStream random(11, 0, index);
  const auto triangles = static_cast<std::uint32_t>(world.scene().triangles.size());
  const std::uint32_t triangle = static_cast<std::uint32_t>(random.next_bits() % triangles);
  const float root = std::sqrt(random.next_float()), second = random.next_float();
  const float radius = std::sqrt(random.next_float()), angle = 2.0F * pi * random.next_float();
  SurfaceRay made;
  made.sample = world.sample_at(triangle, {root * (1.0F - second), root * second}, world.normal(triangle));
  made.ray.origin = world.ray_origin(made.sample);
  made.ray.direction =
      Frame(made.sample.normal)
          .to_world({radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(1e-8F, 1.0F - radius * radius))});
  return made;
}

bool coplanar(const World& world, std::uint32_t a, std::uint32_t b) {
  const Vec3 first = world.position(a, {0.3F, 0.3F}), second = world.position(b, {0.3F, 0.3F});
  const Vec3 normal = world.normal(a);
  return glm::dot(normal, world.normal(b)) > 0.99999F &&
         std::abs(glm::dot(normal, second - first)) < 1e-4F * glm::distance(first, second);
}

/// Rays that left a closed convex shape, and rays that met their own plane again.
struct Faults {
  std::size_t leaks = 0, self_hits = 0, backs = 0;
};

Faults count_faults(const World& world) {
  Faults faults;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const auto [sample, ray] = surface_ray(world, i);
    const Hit hit = world.rays().closest_hit(ray);
    if (!hit) {
      ++faults.leaks;
      continue;
    }
    if (coplanar(world, hit.triangle, sample.triangle)) ++faults.self_hits;
    if (glm::dot(world.normal(hit.triangle), ray.direction) > 0.0F) ++faults.backs;
  }
  return faults;
}

/// A room whose eight corners are moved about: no wall is axis-parallel, and quads become two tilted triangles.
Scene irregular_room(bool convex) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, Vec3(-1.0F), Vec3(1.0F));
  Scene scene = builder.build("irregular");
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    RandomStream random(5, 5, i);
    const Vec3 jitter(random.next_float() - 0.5F, random.next_float() - 0.5F, random.next_float() - 0.5F);
    if (!convex) scene.vertices[i] += 0.3F * jitter;
  }
  tessellate(scene);
  return scene;
}

struct Placement {
  float scale, degrees;
  Vec3 translation;  ///< in units of the scale
};

class ClosedRoom : public testing::TestWithParam<Placement> {
 protected:
  static World placed(const Scene& scene) {
    const Placement p = GetParam();
    return World(made::transformed(scene, p.scale, {1.0F, 2.0F, 0.5F}, p.degrees, p.scale * p.translation), 1);
  }
};

TEST_P(ClosedRoom, CubeHasNoSelfHitsAndNoLeaks) {
  const Faults faults = count_faults(placed(irregular_room(true)));
  EXPECT_EQ(faults.leaks, 0U);
  EXPECT_EQ(faults.self_hits, 0U);
  EXPECT_EQ(faults.backs, 0U);
}

TEST_P(ClosedRoom, IrregularRoomHasNoSelfHitsAndNoLeaks) {
  const Faults faults = count_faults(placed(irregular_room(false)));
  EXPECT_EQ(faults.leaks, 0U);
  EXPECT_EQ(faults.self_hits, 0U);
  EXPECT_EQ(faults.backs, 0U);
}

INSTANTIATE_TEST_SUITE_P(Scales, ClosedRoom,
                         testing::Values(Placement{1e-3F, 0.0F, {}}, Placement{1e-3F, 33.0F, {}}, Placement{1.0F, 0.0F, {}},
                                         Placement{1.0F, 33.0F, {}}, Placement{1.0F, 77.0F, {2.0F, -1.0F, 3.0F}},
                                         Placement{1e2F, 12.0F, {}}, Placement{1e4F, 0.0F, {}}, Placement{1e4F, 33.0F, {}}));

/// A wall one millimetre thick between two rooms of ten metres: light of one must not reach the other.
TEST(World, AMillimetreWallIsTight) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("left", white, {-5.0F, 0.0F, -5.0F}, {-0.0005F, 3.0F, 5.0F})
      .room("right", white, {0.0005F, 0.0F, -5.0F}, {5.0F, 3.0F, 5.0F});
  const World world(made::transformed(builder.build("thin wall"), 1.0F, {0.0F, 1.0F, 0.0F}, 20.0F), 1);
  std::size_t crossings = 0;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const auto [sample, ray] = surface_ray(world, i);
    const Hit hit = world.rays().closest_hit(ray);
    ASSERT_TRUE(hit);
    if (world.scene().triangle_object[hit.triangle] != sample.object) ++crossings;
  }
  EXPECT_EQ(crossings, 0U);
}

/// A closed slit one millimetre high and a metre wide, `distance` off the scene's middle as in a district of that
/// size: the offset from one side must not carry a ray's origin through the other.
class MillimetreSlit : public testing::TestWithParam<float> {};

TEST_P(MillimetreSlit, HoldsItsRays) {
  made::SceneBuilder builder;
  builder.room("slit", builder.diffuse("white", Rgb(0.5F)), {-0.5F, -0.0005F, -0.5F}, {0.5F, 0.0005F, 0.5F});
  const Vec3 away(0.5F * GetParam(), GetParam(), -GetParam());
  const World world(made::transformed(builder.build("slit"), 1.0F, {1.0F, 2.0F, 0.5F}, 33.0F, away), 1);
  std::size_t leaks = 0, own = 0;
  for (std::size_t i = 0; i < ray_count; ++i) {
    const auto [sample, ray] = surface_ray(world, i);
    // On the narrow sides the rounding of a position, 3e-5 m there, is a part of the height: they lie across the edge.
    if (world.area(sample.triangle) < 0.1F) continue;
    const Hit hit = world.rays().closest_hit(ray);
    if (!hit || glm::dot(world.normal(hit.triangle), ray.direction) > 0.0F) ++leaks;
    else if (hit.triangle == sample.triangle) ++own;
  }
  // A sample lies within that rounding of an edge about once in ten thousand times.
  EXPECT_LT(leaks, ray_count / 10'000);
  EXPECT_EQ(own, 0U);
}

INSTANTIATE_TEST_SUITE_P(Distances, MillimetreSlit, testing::Values(0.0F, 50.0F, 500.0F));

/// Many coplanar triangles: a ray along the surface must pass over all its neighbours.
TEST(World, CoplanarNeighboursAreNotHit) {
  constexpr int cells = 40;
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  std::vector<Vec3> vertices;
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (int z = 0; z <= cells; ++z)
    for (int x = 0; x <= cells; ++x) vertices.push_back({0.37F * static_cast<float>(x), 0.0F, 0.37F * static_cast<float>(z)});
  for (std::uint32_t z = 0; z < cells; ++z)
    for (std::uint32_t x = 0; x < cells; ++x) {
      const std::uint32_t first = z * (cells + 1) + x;
      faces.push_back({first, first + cells + 1, first + cells + 2, first + 1});
    }
  builder.object("floor", white, vertices, faces);
  const Scene flat = builder.build("floor");
  for (const float degrees : {0.0F, 31.0F}) {
    const World world(made::transformed(flat, 1.0F, {1.0F, 0.3F, 0.2F}, degrees), 1);
    std::size_t hits = 0;
    for (std::size_t i = 0; i < ray_count; ++i) hits += world.rays().occluded(surface_ray(world, i).ray) ? 1U : 0U;
    EXPECT_EQ(hits, 0U) << "tilted by " << degrees << " degrees";
  }
}

TEST(World, SegmentsBetweenPointsInSightAreFree) {
  const World world(made::transformed(irregular_room(false), 3.0F, {1.0F, 1.0F, 0.0F}, 40.0F), 1);
  std::size_t tested = 0, blocked = 0;
  for (std::size_t i = 0; i + 1 < ray_count; i += 2) {
    const SurfaceSample a = surface_ray(world, i).sample, b = surface_ray(world, i + 1).sample;
    const Vec3 path = b.position - a.position;
    const float length = glm::length(path);
    // Within a hair's breadth of an edge or a reflex one the room itself may stand between.
    if (glm::dot(path, a.normal) < 0.05F * length || glm::dot(-path, b.normal) < 0.05F * length) continue;
    Ray whole{world.ray_origin(a), 0.0F, path / length, length * 0.99F};
    if (world.rays().occluded(whole)) continue;
    ++tested;
    blocked += world.rays().occluded(world.segment(a, b)) ? 1U : 0U;
  }
  EXPECT_GT(tested, 20'000U);
  EXPECT_EQ(blocked, 0U);
}

TEST(World, ASegmentThroughAWallIsBlocked) {
  const World world(made::box_scene(), 1);
  const Scene& scene = world.scene();
  const auto object = [&](const std::string& name) {
    for (const Object& o : scene.objects)
      if (o.name == name) return o;
    return Object{};
  };
  const std::uint32_t floor = object("floor").triangle_begin, tall = object("tall").triangle_end - 1;
  const SurfaceSample on_floor = world.sample_at(floor, {0.3F, 0.3F}, {0, 1, 0});
  const SurfaceSample on_block = world.sample_at(tall, {0.3F, 0.3F}, world.normal(tall));
  SurfaceSample beyond = on_floor;
  beyond.position = {0.3F, 0.7F, 0.3F};  // over the tall block, seen from the floor under it through the block
  SurfaceSample under = on_floor;
  under.position = {0.3F, 0.0F, 0.3F};
  EXPECT_TRUE(world.rays().occluded(world.segment(under, beyond)));
  EXPECT_EQ(on_block.object, scene.triangle_object[tall]);
}

TEST(World, KnowsAreasNormalsAndBounds) {
  made::BoxOptions options;
  options.blocks = false;
  options.lamp_emission = Rgb(0.0F);
  const World world(made::transformed(made::box_scene(options), 2.0F), 1);
  EXPECT_DOUBLE_EQ(world.total_area(), 24.0);
  EXPECT_FLOAT_EQ(world.diagonal(), std::sqrt(12.0F));
  const Vec3 centre = 0.5F * (world.bounds_min() + world.bounds_max());
  for (std::uint32_t t = 0; t < world.scene().triangles.size(); ++t) {
    EXPECT_FLOAT_EQ(world.area(t), 2.0F);
    EXPECT_NEAR(glm::length(world.normal(t)), 1.0F, 1e-6F);
    EXPECT_GT(glm::dot(world.normal(t), centre - world.position(t, {0.3F, 0.3F})), 0.0F) << "walls face inwards";
  }
}

TEST(World, BacksAreBlackUnlessTwoSided) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const std::array<Vec3, 4> square{{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}};
  builder.quad("one", white, square).quad("both", white, square, true);
  const World world(builder.build("sides"), 1);
  const auto sample = [&](std::uint32_t triangle, float up) { return world.sample_at(triangle, {0.2F, 0.2F}, {0, up, 0}); };
  EXPECT_TRUE(sample(0, 1.0F).lit_side);
  EXPECT_FALSE(sample(0, -1.0F).lit_side);
  EXPECT_TRUE(sample(2, 1.0F).lit_side);
  EXPECT_TRUE(sample(2, -1.0F).lit_side);
  EXPECT_EQ(sample(2, -1.0F).normal, Vec3(0, -1, 0));
  EXPECT_EQ(sample(2, 1.0F).object, 1U);
  EXPECT_EQ(sample(2, 1.0F).face, 1U);
}

TEST(World, DegenerateTrianglesHaveNoAreaAndNoNormal) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.object("line", white, {{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2, 2}});
  const World world(builder.build("line"), 1);
  EXPECT_EQ(world.area(0), 0.0F);
  EXPECT_EQ(world.normal(0), Vec3(0.0F));
  const World empty(Scene{}, 1);
  EXPECT_EQ(empty.total_area(), 0.0);
  EXPECT_EQ(empty.diagonal(), 0.0F);
}

}  // namespace
}  // namespace gibench
