#include <gtest/gtest.h>

#include <optional>

#include "common/ray/embree/embree_backend.h"
#include "common/ray/world.h"
#include "common/scene/made_scenes.h"
#include "tests/common/ray/brute_force.h"

namespace gibench {
namespace {

/// A room whose worlds count the trees that are built for them.
class SharedGeometry : public testing::Test {
 protected:
  SharedGeometry() {
    const auto counted = [this](std::span<const Vec3> vertices, std::span<const Triangle> triangles, int threads) {
      ++trees;
      return make_embree_backend(vertices, triangles, threads);
    };
    made::BoxOptions options;
    options.lights = {PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)}};
    world.emplace(made::box_scene(options), 1, counted);
  }

  int trees = 0;
  std::optional<World> world;
};

TEST_F(SharedGeometry, AMaterialEditKeepsTheTree) {
  Scene scene = world->scene();
  scene.materials[0].diffuse = Rgb(0.25F);
  const World after(scene, *world);
  EXPECT_EQ(trees, 1);
  EXPECT_EQ(&after.geometry().rays(), &world->geometry().rays());
  EXPECT_EQ(&after.geometry(), &world->geometry());
  EXPECT_EQ(after.scene().materials[0].diffuse, Rgb(0.25F));
  EXPECT_NE(world->scene().materials[0].diffuse, Rgb(0.25F)) << "what is edited is the new world alone";
}

TEST_F(SharedGeometry, ALightEditKeepsTheTree) {
  Scene scene = world->scene();
  std::get<PointLight>(scene.lights[0]).position = {0.2F, 0.9F, 0.5F};
  const World after(scene, *world);
  scene.lights.clear();
  scene.cameras.clear();
  const World dark(scene, after);
  EXPECT_EQ(trees, 1);
  EXPECT_EQ(&after.geometry(), &world->geometry());
  EXPECT_EQ(&dark.geometry(), &world->geometry());
}

TEST_F(SharedGeometry, AMovedObjectBuildsATreeOfItsOwn) {
  Scene scene = world->scene();
  const Object& lamp = scene.objects.back();
  for (std::uint32_t i = lamp.vertex_begin; i < lamp.vertex_end; ++i) scene.vertices[i].y += 0.125F;
  const World after(scene, *world);
  EXPECT_EQ(trees, 2);
  EXPECT_NE(&after.rays(), &world->rays());
  EXPECT_GT(after.position(lamp.triangle_begin, {0.3F, 0.3F}).y, world->position(lamp.triangle_begin, {0.3F, 0.3F}).y);
  const World recoloured(scene, after);
  EXPECT_EQ(trees, 2) << "what follows on the move stands on its tree";
  EXPECT_EQ(&recoloured.geometry(), &after.geometry());
}

TEST_F(SharedGeometry, OtherTrianglesBuildATreeOfTheirOwn) {
  Scene scene = world->scene();
  std::swap(scene.triangles.front().corners[0], scene.triangles.front().corners[1]);
  const World turned(scene, *world);
  EXPECT_EQ(trees, 2);
  EXPECT_EQ(turned.normal(0), -world->normal(0));
  scene.triangles.pop_back();
  const World fewer(scene, turned);
  EXPECT_EQ(trees, 3);
}

TEST_F(SharedGeometry, OutlivesTheWorldThatBuiltIt) {
  const Ray down{{0.5F, 0.9F, 0.1F}, 0.0F, {0.0F, -1.0F, 0.0F}};
  const Hit before = world->rays().closest_hit(down);
  const World after(world->scene(), *world);
  world.reset();
  const Hit hit = after.rays().closest_hit(down);
  ASSERT_TRUE(hit);
  EXPECT_EQ(hit.triangle, before.triangle);
  EXPECT_EQ(hit.distance, before.distance);
}

/// Sides are the object's matter, which every world takes from its own scene.
TEST_F(SharedGeometry, WhatIsNotShapeIsEachWorldsOwn) {
  Scene scene = world->scene();
  scene.objects[0].two_sided = true;
  const World after(scene, *world);
  const std::uint32_t triangle = scene.objects[0].triangle_begin;
  EXPECT_EQ(trees, 1);
  EXPECT_FALSE(world->sample_at(triangle, {0.3F, 0.3F}, -world->normal(triangle)).lit_side);
  EXPECT_TRUE(after.sample_at(triangle, {0.3F, 0.3F}, -after.normal(triangle)).lit_side);
}

/// A world's backend goes on to the worlds after it.
TEST(WorldBackend, AnEditedWorldKeepsItsBackend) {
  const World world(made::box_scene(), 1, test::make_brute_force_backend);
  Scene scene = world.scene();
  for (Vec3& vertex : scene.vertices) vertex *= 2.0F;
  const World after(scene, world);
  EXPECT_NE(dynamic_cast<const test::BruteForceBackend*>(&after.geometry().rays()), nullptr);
}

}  // namespace
}  // namespace gibench
