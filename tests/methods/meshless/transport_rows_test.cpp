#include "methods/meshless/transport_rows.h"

#include <gtest/gtest.h>

#include "common/finite_elements/surface_point.h"
#include "common/scene/made_scenes.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

constexpr std::uint32_t levels = 2;
constexpr double epsilon_omega = 0.3;

/// Light that varies over the box, in the basis of its coarse levels.
Coefficients uneven(const test::BasisScene& scene, int channels) {
  const Coefficients three = scene.approximate_fully(levels - 1, [](const Place& at) {
    return Rgb(1.0F + at.position.x, 2.0F * at.position.y, 0.5F + at.position.z * at.position.x);
  });
  Coefficients made(scene.hierarchy, channels);
  for (const std::uint32_t point : three.sorted_points()) made.set(point, channels == 1 ? Rgb(three[point].r) : three[point]);
  return made;
}

/// What gathers bring from the basis, and what the rows made from the same rays say.
void expect_rows_to_be_gathers(const test::BasisScene& scene, int channels) {
  const Coefficients sent = uneven(scene, channels);
  const BasisSender sender(sent, scene.groups, epsilon_omega);
  const Gatherer gatherer(scene.world, 256);
  TransportRows rows(scene.hierarchy, scene.groups, levels, epsilon_omega, channels);
  ASSERT_EQ(rows.size(), scene.hierarchy.level_begin(levels));
  Task task;
  std::vector<Estimate> gathered(rows.size());
  {
    RayStream stream = task.rays(scene.world);
    GatherBuffers buffers;
    for (std::uint32_t point = 0; point < rows.size(); ++point) {
      const std::uint32_t triangle = scene.hierarchy.triangle(point);
      const SurfaceSample receiver =
          surface_sample(scene.world, triangle, scene.hierarchy.position(point), scene.world.normal(triangle));
      gathered[point] = gatherer.irradiance(receiver, point, sender, stream, buffers);
      rows.keep(point, gatherer, buffers);
    }
    EXPECT_EQ(buffers.counts.uncovered, 0U);
  }
  const std::vector<Estimate> applied = rows.apply(sent, task);
  // Rounding may decide whether a finer level counts at a hit: that is albedo · coefficient / rays, 0.75 · 0.2 / 256 at most.
  for (std::uint32_t point = 0; point < rows.size(); ++point)
    for (int channel = 0; channel < channels; ++channel)
      EXPECT_NEAR(applied[point].value[channel], gathered[point].value[channel], 6e-4F);
  EXPECT_GT(rows.links(), rows.size());
  EXPECT_GT(rows.bytes(), 8U * rows.links());
}

TEST(TransportRows, BringWhatAGatherFromTheBasisBrings) { expect_rows_to_be_gathers(test::BasisScene(made::box_scene()), 3); }

TEST(TransportRows, KeepOneChannelOfGreyLight) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("grey", Rgb(0.6F)), {0, 0, 0}, {1, 1, 2});
  expect_rows_to_be_gathers(test::BasisScene(builder.build("room")), 1);
}

TEST(TransportRows, EvenLightArrivesAsTheReflectanceSeenAndNothingAsNothing) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("grey", Rgb(0.25F)), {0, 0, 0}, {1, 1, 1});
  const test::BasisScene scene(builder.build("room"));
  TransportRows rows(scene.hierarchy, scene.groups, 1, epsilon_omega, 3);
  const Gatherer gatherer(scene.world, 64);
  const Coefficients even = scene.approximate_fully(0, [](const Place&) { return Rgb(2.0F); });
  const BasisSender sender(even, scene.groups, epsilon_omega);
  Task task;
  RayStream stream = task.rays(scene.world);
  GatherBuffers buffers;
  const SurfaceSample receiver =
      surface_sample(scene.world, scene.hierarchy.triangle(5), scene.hierarchy.position(5), scene.hierarchy.normal(5));
  gatherer.irradiance(receiver, 1, sender, stream, buffers);
  rows.keep(5, gatherer, buffers);
  const std::vector<Estimate> arriving = rows.apply(even, task);
  EXPECT_NEAR(arriving[5].value.g, 0.5F, 1e-5F);
  EXPECT_LT(arriving[5].deviation, 1e-5F);
  EXPECT_EQ(arriving[4].value, Rgb()) << "no gather was kept there";
}

}  // namespace
}  // namespace gibench::meshless
