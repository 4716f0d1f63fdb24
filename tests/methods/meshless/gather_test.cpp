#include "methods/meshless/gather.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/scene/made_scenes.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

constexpr int gathered_rays = 512;

/// The same irradiance everywhere, or on some triangles only.
class ConstantSender : public Sender {
 public:
  explicit ConstantSender(Rgb value) : value_(value) {}
  void irradiance(std::span<const SurfaceSample> hits, const Vec3&, std::uint64_t, RayStream&, std::span<Rgb> values,
                  SenderCounts&) const override {
    for (std::size_t i = 0; i < hits.size(); ++i) values[i] = value_;
  }

 private:
  Rgb value_;
};

Estimate gathered(const World& world, const SurfaceSample& receiver, const Sender& sender, std::uint64_t key = 1) {
  Task task;
  RayStream stream = task.rays(world);
  GatherBuffers buffers;
  return Gatherer(world, gathered_rays).irradiance(receiver, key, sender, stream, buffers);
}

SurfaceSample sample_on(const World& world, std::uint32_t triangle, Vec2 barycentrics = {0.3F, 0.3F}) {
  return world.sample_at(triangle, barycentrics, world.normal(triangle));
}

TEST(Gather, IsExactInAUniformEnclosure) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("grey", Rgb(0.3F, 0.6F, 0.9F)), {0, 0, 0}, {2, 1, 3});
  const World world(builder.build("room"), 1);
  const ConstantSender sender(Rgb(2.0F));
  for (std::uint32_t triangle = 0; triangle < 12; ++triangle) {
    const Estimate estimate = gathered(world, sample_on(world, triangle), sender, triangle);
    EXPECT_NEAR(estimate.value.r, 0.6F, 1e-5F);
    EXPECT_NEAR(estimate.value.g, 1.2F, 1e-5F);
    EXPECT_NEAR(estimate.value.b, 1.8F, 1e-5F);
    EXPECT_LT(estimate.deviation, 1e-5F);
  }
}

/// Form factor from a differential patch at the origin of the plane z = 0, facing up, to a rectangle of the plane
/// z = h over [0,a] × [0,b] (Howell, A Catalog of Radiation Heat Transfer Configuration Factors, B-3).
double corner_form_factor(double a, double b, double h) {
  const double x = a / h, y = b / h;
  return (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
          y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y))) /
         (2.0 * pi_double);
}

TEST(Gather, GivesTheFormFactorOfARectangleAndADeviationThatCoversTheError) {
  made::SceneBuilder builder;
  const std::uint32_t grey = builder.diffuse("grey", Rgb(0.5F));
  builder.quad("floor", grey, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("ceiling", grey, {{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}});
  const World world(builder.build("plates"), 1);
  const ConstantSender sender(Rgb(4.0F));
  double errors = 0.0, deviations = 0.0;
  const int places = 64;
  // The edge of the ceiling crosses about 2.5 · √512 = 57 cells of the pattern, each right by chance to within 1/√6 of a
  // ray: a deviation of 0.012 of 4 · 0.5; four of them for each place.
  for (int i = 0; i < places; ++i) {
    RandomStream random(5, 0, static_cast<std::uint64_t>(i));
    const float u = random.next_float(), v = random.next_float();
    SurfaceSample receiver = sample_on(world, 0);
    receiver.position = {u, 0.0F, v};
    const auto x = static_cast<double>(u), z = static_cast<double>(v);
    const double factor = corner_form_factor(x, z, 1) + corner_form_factor(1 - x, z, 1) + corner_form_factor(x, 1 - z, 1) +
                          corner_form_factor(1 - x, 1 - z, 1);
    const Estimate estimate = gathered(world, receiver, sender, static_cast<std::uint64_t>(i));
    EXPECT_NEAR(static_cast<double>(estimate.value.r), 2.0 * factor, 0.05);
    errors += std::pow(static_cast<double>(estimate.value.r) - 2.0 * factor, 2) / places;
    deviations += std::pow(static_cast<double>(estimate.deviation), 2) / places;
  }
  EXPECT_LT(std::sqrt(errors), 0.015);
  EXPECT_LT(std::sqrt(errors), std::sqrt(deviations));
  EXPECT_GT(std::sqrt(errors), 0.1 * std::sqrt(deviations));
}

TEST(Gather, BacksAndMissesAreBlack) {
  made::SceneBuilder builder;
  const std::uint32_t grey = builder.diffuse("grey", Rgb(0.5F));
  builder.quad("floor", grey, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("lid", grey, {{{-9, 0.1F, -9}, {-9, 0.1F, 9}, {9, 0.1F, 9}, {9, 0.1F, -9}}});  // its front is on top
  const World back(builder.build("back"), 1);
  EXPECT_EQ(gathered(back, sample_on(back, 0), ConstantSender(Rgb(1.0F))).value, Rgb());
  Scene scene = back.scene();
  scene.objects[1].two_sided = true;
  const World both(scene, 1);
  EXPECT_NEAR(gathered(both, sample_on(both, 0), ConstantSender(Rgb(1.0F))).value.r, 0.5F, 0.01F);
}

TEST(Gather, ItsSlopeIsThatOfNearThingsUnlikeTheRest) {
  /// One wall alone sends light.
  class Wall : public Sender {
   public:
    void irradiance(std::span<const SurfaceSample> hits, const Vec3&, std::uint64_t, RayStream&, std::span<Rgb> values,
                    SenderCounts&) const override {
      for (std::size_t i = 0; i < hits.size(); ++i) values[i] = Rgb(hits[i].position.x < 1e-3F ? 1.0F : 0.0F);
    }
  };
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("grey", Rgb(0.5F)), {0, 0, 0}, {2, 1, 3});
  const World world(builder.build("room"), 1);
  const Gatherer gatherer(world, gathered_rays);
  Task task;
  RayStream stream = task.rays(world);
  GatherBuffers buffers;
  const auto slope = [&](float x, float reach, const Sender& sender) {
    const Hit floor = world.rays().closest_hit({{x, 0.5F, 1.5F}, 0.0F, {0, -1, 0}});
    buffers.reach = reach;
    return gatherer.irradiance(world.sample_at(floor.triangle, {floor.u, floor.v}, {0, 1, 0}), 1, sender, stream, buffers).slope;
  };
  EXPECT_LT(slope(0.1F, 0.0F, ConstantSender(Rgb(1.0F))), 1e-4F) << "all alike, as near as it is";
  EXPECT_GT(slope(0.1F, 0.0F, Wall()), 5.0F * slope(1.0F, 0.0F, Wall()));
  // Within a metre light changes by all of its contrast at most: 2 p (1 - p) of the 0.5 that the wall sends, p = 0.45 of all it
  // is.
  EXPECT_LT(slope(0.1F, 1.0F, Wall()), 0.25F);
}

TEST(Gather, TurnsWithTheScene) {
  const Scene box = made::box_scene();
  const World world(box, 1), turned(made::transformed(box, 1.0F, {1, 2, 3}, 40.0F), 1);
  class ByHeight : public Sender {
   public:
    void irradiance(std::span<const SurfaceSample> hits, const Vec3& receiver, std::uint64_t, RayStream&, std::span<Rgb> values,
                    SenderCounts&) const override {
      for (std::size_t i = 0; i < hits.size(); ++i) values[i] = Rgb(glm::distance(hits[i].position, receiver));
    }
  };
  for (std::uint32_t triangle : {0U, 5U, 11U, 20U}) {
    const Rgb a = gathered(world, sample_on(world, triangle), ByHeight()).value;
    const Rgb b = gathered(turned, sample_on(turned, triangle), ByHeight()).value;
    EXPECT_NEAR(a.r, b.r, 2e-3F * a.r);
  }
}

TEST(Gather, BasisSenderSeesTheExpansionAndTheAlbedoOfTheHit) {
  const test::BasisScene scene(made::box_scene());
  const Coefficients made = scene.approximate_fully(1, [](const Place&) { return Rgb(1.0F); });
  const BasisSender sender(made, scene.groups, 0.1);
  const SurfaceSample receiver = sample_on(scene.world, 0);
  const Rgb seen = gathered(scene.world, receiver, sender).value;
  const Rgb expected = gathered(scene.world, receiver, ConstantSender(Rgb(1.0F))).value;
  for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(seen[channel], expected[channel], 1e-4F);
}

TEST(Gather, CountsHitsThatNoBasisFunctionCovers) {
  const test::BasisScene scene(made::box_scene());
  const Coefficients made = scene.approximate_fully(0, [](const Place&) { return Rgb(); });
  const BasisSender sender(made, scene.groups, 0.1);
  std::vector<SurfaceSample> hits = area_uniform_samples(scene.world, 100, 3);
  std::vector<Rgb> values(hits.size());
  Task task;
  RayStream stream = task.rays(scene.world);
  SenderCounts counts;
  sender.irradiance(hits, Vec3(0.5F), 1, stream, values, counts);
  EXPECT_EQ(counts.uncovered, 0U) << "dark, but covered";
  for (SurfaceSample& hit : hits) hit.position += Vec3(10.0F);
  sender.irradiance(hits, Vec3(0.5F), 1, stream, values, counts);
  EXPECT_EQ(counts.uncovered, 100U);
}

}  // namespace
}  // namespace gibench::meshless
