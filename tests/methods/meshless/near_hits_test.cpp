/// The near hits of gathers, and the detail that comes from them.
#include "methods/meshless/near_hits.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "common/finite_elements/surface_point.h"
#include "common/scene/made_scenes.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

constexpr std::uint32_t coarse_levels = 1;

/// Gathers at the coarsest points of a scene, whose near hits were kept.
class KeptHits {
 public:
  explicit KeptHits(double epsilon_omega, Scene scene = made::box_scene(), std::uint64_t seed = 1)
      : scene_(std::move(scene)),
        hits(scene_.hierarchy, scene_.groups, coarse_levels, epsilon_omega, seed),
        gatherer_(scene_.world, 512) {}

  /// What a gather at a point gets from a function.
  Rgb gathered(std::uint32_t point, const Sender& sender, RayStream& rays, GatherBuffers& buffers) const {
    const std::uint32_t triangle = scene_.hierarchy.triangle(point);
    const SurfaceSample receiver =
        surface_sample(scene_.world, triangle, scene_.hierarchy.position(point), scene_.world.normal(triangle));
    return gatherer_.irradiance(receiver, point, sender, rays, buffers).value;
  }
  /// Gathers at all points from a function; calls visit(point, value, buffers) after each.
  template <class Visit>
  void gather(const Coefficients& sent, double epsilon_omega, Visit&& visit) {
    const BasisSender sender(sent, scene_.groups, epsilon_omega);
    std::vector<std::uint32_t> points;
    for (std::uint32_t point = 0; point < scene_.hierarchy.level_begin(coarse_levels); ++point) points.push_back(point);
    hits.announce(points);
    RayStream rays = task.rays(scene_.world);
    GatherBuffers buffers;
    for (const std::uint32_t point : points) {
      const Rgb value = gathered(point, sender, rays, buffers);
      hits.keep(point, gatherer_, buffers);
      visit(point, value, buffers);
    }
  }
  const test::BasisScene& scene() const { return scene_; }
  float share_of_a_ray() const { return 1.0F / static_cast<float>(gatherer_.rays()); }

 private:
  test::BasisScene scene_;

 public:
  NearHits hits;
  Task task;

 private:
  Gatherer gatherer_;
};

/// A function that only the second level holds.
template <class Function>
Coefficients detail_of(const test::BasisScene& scene, Function&& function) {
  Coefficients made(scene.hierarchy);
  for (std::uint32_t point = scene.hierarchy.level_begin(1); point < scene.hierarchy.level_begin(2); ++point)
    made.set(point, function(scene.hierarchy.position(point)));
  return made;
}

/// The box without colours: hits weigh the same in every channel, so that the sum of a run's weights is kept.
Scene grey_box() {
  made::BoxOptions options;
  options.left_albedo = Rgb(0.3F);
  options.right_albedo = Rgb(0.5F);
  return made::box_scene(options);
}

/// A floor in the corner of a red wall and a green one.
Scene two_coloured_corner() {
  made::SceneBuilder builder;
  const std::uint32_t red = builder.diffuse("red", Rgb(0.8F, 0.1F, 0.2F));
  const std::uint32_t green = builder.diffuse("green", Rgb(0.1F, 0.6F, 0.3F));
  builder.quad("floor", builder.diffuse("white", Rgb(0.7F)), {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}})
      .quad("red", red, {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}})
      .quad("green", green, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  return builder.build("corner");
}

TEST(NearHits, BringEvenDetailAsTheGatherWouldHave) {
  KeptHits kept(0.0, grey_box());  // every hit calls for all levels
  const Coefficients even = detail_of(kept.scene(), [](const Vec3&) { return Rgb(0.5F, 1.0F, 2.0F); });
  std::vector<Rgb> gathered;
  kept.gather(even, 0.0, [&](std::uint32_t, const Rgb& value, const GatherBuffers&) { gathered.push_back(value); });
  const Coefficients arriving = kept.hits.arriving(even, kept.task);
  for (std::uint32_t point = 0; point < gathered.size(); ++point)
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(arriving[point][channel], gathered[point][channel], 1e-4F * gathered[point][channel]);
  EXPECT_EQ(arriving.size(), gathered.size());
}

TEST(NearHits, OneOfNeighbouringHitsStandsForAllWithoutBias) {
  KeptHits kept(0.0);
  const Coefficients waves =
      detail_of(kept.scene(), [](const Vec3& at) { return Rgb(1.0F + std::sin(9.0F * (at.x + at.y + at.z))); });
  std::vector<Rgb> gathered;
  kept.gather(waves, 0.0, [&](std::uint32_t, const Rgb& value, const GatherBuffers&) { gathered.push_back(value); });
  const Coefficients arriving = kept.hits.arriving(waves, kept.task);
  double sum = 0.0, apart = 0.0, squares = 0.0;
  for (std::uint32_t point = 0; point < gathered.size(); ++point) {
    const auto difference = static_cast<double>(arriving[point].g - gathered[point].g);
    sum += static_cast<double>(gathered[point].g), apart += difference, squares += difference * difference;
  }
  // The differences are independent from point to point: five standard deviations of their mean.
  EXPECT_LT(std::fabs(apart), 5.0 * std::sqrt(squares));
  EXPECT_LT(std::sqrt(squares * static_cast<double>(gathered.size())), 0.1 * sum);
  EXPECT_LT(kept.hits.size(), gathered.size() * 512 / 7);
}

TEST(NearHits, OfTwoColoursStandForAllWithoutBiasInEveryChannel) {
  KeptHits kept(0.0, two_coloured_corner());
  // Light on the red wall for the most part: where a hit there stands for some of the green wall too, it must not bring their
  // green.
  const Coefficients uneven = detail_of(kept.scene(), [](const Vec3& at) { return Rgb(at.x < 1e-4F ? 1.0F : 0.1F); });
  std::vector<Rgb> gathered;
  kept.gather(uneven, 0.0, [&](std::uint32_t, const Rgb& value, const GatherBuffers&) { gathered.push_back(value); });
  const Coefficients arriving = kept.hits.arriving(uneven, kept.task);
  RgbDouble apart, squares, sum;
  for (std::uint32_t point = 0; point < gathered.size(); ++point) {
    const RgbDouble difference = RgbDouble(arriving[point]) - RgbDouble(gathered[point]);
    apart += difference, squares += difference * difference, sum += RgbDouble(gathered[point]);
  }
  // The differences are independent from point to point: five standard deviations of their sum, too few to hide a bias in.
  for (int channel = 0; channel < 3; ++channel) {
    const double deviation = std::sqrt(squares[channel]);
    EXPECT_LT(std::fabs(apart[channel]), 5.0 * deviation) << channel;
    EXPECT_LT(5.0 * deviation, 0.02 * sum[channel]) << channel;
  }
}

TEST(NearHits, AreChosenByTheSeed) {
  const auto arriving = [](std::uint64_t seed) {
    KeptHits kept(0.0, two_coloured_corner(), seed);
    const Coefficients slope = detail_of(kept.scene(), [](const Vec3& at) { return Rgb(at.x + at.y + at.z); });
    std::vector<float> values;
    kept.gather(slope, 0.0, [](std::uint32_t, const Rgb&, const GatherBuffers&) {});
    const Coefficients made = kept.hits.arriving(slope, kept.task);
    for (const std::uint32_t point : made.sorted_points()) values.push_back(made[point].g);
    return values;
  };
  EXPECT_EQ(arriving(1), arriving(1));
  EXPECT_NE(arriving(1), arriving(2));
}

TEST(NearHits, AreThoseThatTheCoarseLevelsAreTooCoarseFor) {
  constexpr double epsilon_omega = 1.0;
  KeptHits kept(epsilon_omega, grey_box());
  const Hierarchy& hierarchy = kept.scene().hierarchy;
  // The mean ball subtends 2π (1 − cos θ) at the distance radius / sin θ.
  double radius = 0.0;
  for (std::uint32_t point = 0; point < hierarchy.level_size(0); ++point)
    radius += static_cast<double>(hierarchy.radius(point)) / hierarchy.level_size(0);
  const double cosine = 1.0 - epsilon_omega / (2.0 * pi_double);
  const auto reach = static_cast<float>(radius / std::sqrt(1.0 - cosine * cosine));
  const Coefficients even = detail_of(kept.scene(), [](const Vec3&) { return Rgb(1.0F); });
  std::vector<float> near;
  float all = 0.0F;
  kept.gather(even, epsilon_omega, [&](std::uint32_t point, const Rgb&, const GatherBuffers& buffers) {
    near.push_back(0.0F);
    for (std::size_t i = 0; i < buffers.lit.size(); ++i) {
      const float share = buffers.albedos[i].g * kept.share_of_a_ray();
      all += share;
      if (glm::length(buffers.lit[i].position - hierarchy.position(point)) < reach) near.back() += share;
    }
  });
  const Coefficients arriving = kept.hits.arriving(even, kept.task);
  float sum = 0.0F;
  for (std::uint32_t point = 0; point < near.size(); ++point) {
    EXPECT_NEAR(arriving[point].g, near[point], 1e-3F);
    sum += near[point];
  }
  EXPECT_GT(sum, 0.02F * all);
  EXPECT_LT(sum, 0.9F * all);
}

TEST(NearHits, OfSendersOnAllLevelsThereAreNone) {
  const test::BasisScene scene(made::box_scene());
  const NearHits hits(scene.hierarchy, scene.groups, scene.hierarchy.levels(), 0.3, 1);
  Task task;
  EXPECT_EQ(hits.arriving(Coefficients(scene.hierarchy), task).size(), 0U);
  EXPECT_EQ(hits.size(), 0U);
}

}  // namespace
}  // namespace gibench::meshless
