#include "common/spaces/surface_domain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "common/core/error.h"
#include "common/geometry/surface_sampling.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

/// Two closed rooms side by side, a camera in the first, and a large ground plane below both that no camera sees.
Scene two_rooms(bool with_camera = true) {
  made::SceneBuilder builder;
  const auto white = builder.diffuse("white", Rgb(0.5F));
  builder.room("lit", white, {0, 0, 0}, {1, 1, 1}).room("dark", white, {2, 0, 0}, {3, 1, 1});
  builder.block("block", white, {0.4F, 0.0F, 0.4F}, {0.6F, 0.2F, 0.6F});
  builder.quad("ground", white, {Vec3(-50, -1, 50), Vec3(50, -1, 50), Vec3(50, -1, -50), Vec3(-50, -1, -50)});
  Camera camera;
  camera.name = "view";
  camera.position = {0.5F, 0.5F, 0.95F}, camera.look_at = {0.5F, 0.5F, 0.0F}, camera.up = {0, 1, 0};
  camera.vertical_fov_degrees = 110.0F;
  if (with_camera) builder.camera(camera);
  return builder.build("two rooms");
}

std::size_t count_on(const World& world, const std::vector<SurfaceSample>& samples, const std::string& object) {
  return static_cast<std::size_t>(std::ranges::count_if(
      samples, [&](const SurfaceSample& sample) { return world.scene().objects[sample.object].name == object; }));
}

TEST(SurfaceDomain, TextsAndDefaults) {
  const Scene scene = two_rooms(), blind = two_rooms(false);
  EXPECT_EQ(to_string(surface_domain_of("", scene, "here")), "seen");
  EXPECT_EQ(to_string(surface_domain_of("", blind, "here")), "all");
  EXPECT_EQ(to_string(surface_domain_of("all", scene, "here")), "all");
  EXPECT_EQ(to_string(surface_domain_of("lit,block", scene, "here")), "lit,block");
  EXPECT_THROW(surface_domain_of("seen", blind, "here"), InputError);
  EXPECT_THROW(surface_domain_of("lit,lamp", scene, "here"), InputError);
}

TEST(SurfaceDomain, GeometryThatNobodySeesIsLeftOut) {
  const World world(two_rooms(), 1);
  const auto all = domain_samples(world, {SurfaceDomain::Kind::all, {}}, 4000, 1, 1);
  EXPECT_GT(count_on(world, all, "ground"), 3900U);
  const auto seen = domain_samples(world, {SurfaceDomain::Kind::seen, {}}, 4000, 1, 1);
  ASSERT_EQ(seen.size(), 4000U);
  EXPECT_EQ(count_on(world, seen, "ground") + count_on(world, seen, "dark"), 0U);
  EXPECT_EQ(count_on(world, seen, "lit") + count_on(world, seen, "block"), 4000U);
}

TEST(SurfaceDomain, WhatTheCameraSeesIsSampledUniformlyByArea) {
  const World world(two_rooms(), 1);
  const auto seen = domain_samples(world, {SurfaceDomain::Kind::seen, {}}, 20000, 2, 1);
  // All of the room is seen, or reached from what is seen: 6 m² less the ground of the block, and five faces of the block, one
  // of which (its bottom) touches the floor and is reached by nothing.
  const double block = 0.04 + 4 * 0.2 * 0.2, room = 6.0 - 0.04, share = block / (block + room);
  const double count = static_cast<double>(count_on(world, seen, "block"));
  EXPECT_NEAR(count / 20000.0, share, 4.0 * std::sqrt(share / 20000.0));
  const auto under = std::ranges::count_if(seen, [&](const SurfaceSample& sample) {
    return std::abs(sample.position.y + world.scene().origin.y) < 1e-4 &&
           std::abs(sample.position.x + world.scene().origin.x - 0.5) < 0.099 &&
           std::abs(sample.position.z + world.scene().origin.z - 0.5) < 0.099;
  });
  EXPECT_EQ(under, 0);
}

/// Rows of rays meet it many cells apart, yet nothing of it is left out.
TEST(SurfaceDomain, APlaneSeenAtAGrazingAngleIsSampledAllOver) {
  made::SceneBuilder builder;
  builder.quad("ground", builder.diffuse("white", Rgb(0.5F)),
               {Vec3(-50, 0, 0), Vec3(50, 0, 0), Vec3(50, 0, -100), Vec3(-50, 0, -100)});
  Camera camera;
  camera.position = {0, 1.6F, 0}, camera.look_at = {0, 1.6F, -1}, camera.up = {0, 1, 0}, camera.vertical_fov_degrees = 45.0F;
  builder.camera(camera);
  const World world(builder.build("plain"), 1);
  std::size_t far = 0;
  const auto seen = domain_samples(world, {SurfaceDomain::Kind::seen, {}}, 4000, 1, 1);
  for (const SurfaceSample& sample : seen) {
    const double z = -(static_cast<double>(sample.position.z) + world.scene().origin.z);
    if (z > 73.0 && z < 90.0) ++far;
  }
  // 45 degrees wide as well as high: of the wedge from 4 to 98 m this band is 0.29.
  EXPECT_GT(far, 800U);
}

TEST(SurfaceDomain, ObjectsByName) {
  const World world(two_rooms(), 1);
  const auto samples = domain_samples(world, {SurfaceDomain::Kind::objects, {"dark"}}, 500, 1, 1);
  EXPECT_EQ(count_on(world, samples, "dark"), 500U);
}

TEST(SurfaceDomain, TheSameForAnyNumberOfThreads) {
  const World world(two_rooms(), 1);
  const auto one = domain_samples(world, {SurfaceDomain::Kind::seen, {}}, 1000, 3, 1);
  const auto two = domain_samples(world, {SurfaceDomain::Kind::seen, {}}, 1000, 3, 2);
  ASSERT_EQ(one.size(), two.size());
  for (std::size_t i = 0; i < one.size(); ++i) EXPECT_EQ(one[i].position, two[i].position);
}

TEST(SurfaceDomain, WholeIsWhatAreaUniformSamplesGive) {
  const World world(two_rooms(), 1);
  const auto all = domain_samples(world, {SurfaceDomain::Kind::whole, {}}, 300, 5, 2),
             plain = area_uniform_samples(world, 300, 5);
  for (std::size_t i = 0; i < plain.size(); ++i) EXPECT_EQ(all[i].position, plain[i].position);
}

/// A room of 1 m with a lamp in a shell of 3 m, both facing inwards, and a two-sided screen in the room.
Scene room_in_an_outer_shell(bool with_lamp = true) {
  made::SceneBuilder builder;
  const auto white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, {0, 0, 0}, {1, 1, 1}).room("shell", white, {-1, -1, -1}, {2, 2, 2});
  builder.quad("screen", white, {Vec3(0.3F, 0, 0.2F), Vec3(0.3F, 0.9F, 0.2F), Vec3(0.3F, 0.9F, 0.8F), Vec3(0.3F, 0, 0.8F)}, true);
  if (with_lamp) builder.light(PointLight{{0.6F, 0.5F, 0.5F}, Rgb(1.0F)});
  return builder.build("room in a shell");
}

TEST(SurfaceDomain, WhatIsSealedFromLightAndCamerasIsNoPartOfAll) {
  const World world(room_in_an_outer_shell(), 1);
  DomainFacts facts;
  const auto all = domain_samples(world, {SurfaceDomain::Kind::all, {}}, 4000, 1, 2, &facts);
  ASSERT_EQ(all.size(), 4000U);
  EXPECT_EQ(count_on(world, all, "shell"), 0U);
  const double screen = 2 * 0.9 * 0.6, share = screen / (6.0 + screen);
  EXPECT_NEAR(static_cast<double>(count_on(world, all, "screen")) / 4000.0, share, 4.0 * std::sqrt(share / 4000.0));
  ASSERT_TRUE(facts.sealed_share.has_value());
  EXPECT_NEAR(*facts.sealed_share, 54.0 / (60.0 + screen), 1e-4);
  EXPECT_NE(facts.note().find("88.4%"), std::string::npos) << facts.note();
  EXPECT_FALSE(facts.nothing_reached);
}

TEST(SurfaceDomain, WhatIsSealedDoesNotDependOnSeedAndThreads) {
  const World world(room_in_an_outer_shell(), 1);
  DomainFacts one, other;
  const auto samples = domain_samples(world, {SurfaceDomain::Kind::all, {}}, 500, 1, 1, &one);
  const auto again = domain_samples(world, {SurfaceDomain::Kind::all, {}}, 500, 1, 3);
  domain_samples(world, {SurfaceDomain::Kind::all, {}}, 500, 2, 2, &other);
  EXPECT_EQ(one.sealed_share, other.sealed_share);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(samples[i].position, again[i].position);
}

TEST(SurfaceDomain, WithoutLightAllIsTheWholeSurface) {
  const World world(room_in_an_outer_shell(false), 1);
  DomainFacts facts;
  const auto all = domain_samples(world, {SurfaceDomain::Kind::all, {}}, 2000, 1, 2, &facts);
  EXPECT_NEAR(static_cast<double>(count_on(world, all, "shell")) / 2000.0, 54.0 / 61.08, 0.01);
  EXPECT_TRUE(facts.nothing_reached);
  EXPECT_EQ(facts.sealed_share, 0.0);
  EXPECT_FALSE(facts.note().empty());
}

/// No light comes to it, but it is looked at.
TEST(SurfaceDomain, WhatOnlyACameraReachesIsAPartOfAll) {
  Scene scene = two_rooms();
  scene.lights.emplace_back(PointLight{{2.5F, 0.5F, 0.5F}, Rgb(1.0F)});
  const World world(scene, 1);
  const auto all = domain_samples(world, {SurfaceDomain::Kind::all, {}}, 2000, 1, 2);
  EXPECT_GT(count_on(world, all, "lit"), 600U);
  EXPECT_GT(count_on(world, all, "dark"), 600U);
  EXPECT_EQ(count_on(world, all, "ground"), 0U);
}

}  // namespace
}  // namespace gibench
