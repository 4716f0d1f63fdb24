/// The global operator: equal to the solution bounce by bounce without compression, and honest about what compression takes.
#include "methods/wavelet/global_operator.h"

#include <gtest/gtest.h>

#include <cmath>

#include "methods/wavelet/bounces.h"
#include "rooms.h"

namespace gibench::test {
namespace {

using namespace wavelet;

struct Bouncing {
  World world;
  Task task;
  StageReport report;
  Precomputed made;
  std::vector<Rgb> reflectance;
  Coefficients<Rgb> direct;

  explicit Bouncing(Scene scene, const char* leaves = "200")
      : world(std::move(scene), 1),
        made(precompute(world,
                        wavelet_settings({{"leaves", leaves}, {"receiver_threshold", "0.01"}, {"sender_threshold", "0.01"}}),
                        true, task, report)) {
    for (const Element& element : made.elements.elements())
      reflectance.push_back(world.scene().material_of_object(element.object).diffuse);
    std::vector<Rgb> means;
    for (std::size_t leaf = 0; leaf < made.elements.leaves().size(); ++leaf)
      means.emplace_back(1.0F, 0.5F, static_cast<float>(leaf % 7));
    direct = coefficients_of<Rgb>(made.elements, means);
  }
  IndirectLight solved(double residual) {
    return bounce(made.elements, made.transport, direct, reflectance, {{}, 10000, residual}, task);
  }
};

double difference(const Coefficients<Rgb>& a, const Coefficients<Rgb>& b) {
  double change = 0.0, whole = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      change += std::pow(static_cast<double>(a[i][c]) - static_cast<double>(b[i][c]), 2.0);
      whole += std::pow(static_cast<double>(a[i][c]), 2.0);
    }
  return std::sqrt(change / whole);
}

TEST(WaveletGlobal, WithoutCompressionIsTheSolution) {
  Bouncing room(open_corner());
  const IndirectLight solved = room.solved(1e-8);
  const GlobalOperator global(room.made.elements, room.made.transport, room.reflectance, {0.0, 40}, room.task);
  for (const bool gathered : {false, true}) {
    const IndirectLight light =
        all_bounces(room.made.elements, room.made.transport, global, gathered, room.direct, room.reflectance, room.task);
    EXPECT_LT(difference(solved.irradiance, light.irradiance), 1e-5) << gathered;
  }
}

TEST(WaveletGlobal, CompressionEndsTheSeriesAndGatheringGivesSomeOfItBack) {
  Bouncing room(open_corner());
  const IndirectLight solved = room.solved(1e-8);
  const GlobalOperator fine(room.made.elements, room.made.transport, room.reflectance, {1e-4, 1000}, room.task);
  const GlobalOperator coarse(room.made.elements, room.made.transport, room.reflectance, {1e-2, 1000}, room.task);
  EXPECT_LT(coarse.links(), fine.links());
  EXPECT_LT(coarse.powers().size(), fine.powers().size());
  EXPECT_LT(coarse.powers().back().links, coarse.powers().front().links);
  const auto error = [&](const GlobalOperator& global, bool gathered) {
    return difference(solved.irradiance, all_bounces(room.made.elements, room.made.transport, global, gathered, room.direct,
                                                     room.reflectance, room.task)
                                             .irradiance);
  };
  EXPECT_LT(error(fine, false), 0.01);
  EXPECT_LT(error(fine, false), error(coarse, false));
  EXPECT_LT(error(coarse, true), error(coarse, false));
}

TEST(WaveletGlobal, WithoutCompressionEndsAtRounding) {
  Bouncing room(furnace(0.5F), "24");
  const GlobalOperator global(room.made.elements, room.made.transport, room.reflectance, {0.0, 100000}, room.task);
  EXPECT_LT(global.powers().size(), 60U);
  const IndirectLight light =
      all_bounces(room.made.elements, room.made.transport, global, false, room.direct, room.reflectance, room.task);
  EXPECT_LT(difference(room.solved(1e-8).irradiance, light.irradiance), 1e-5);
}

TEST(WaveletGlobal, RefusesToPassItsBytes) {
  Bouncing room(open_corner());
  const GlobalOperator whole(room.made.elements, room.made.transport, room.reflectance, {1e-4, 100}, room.task);
  EXPECT_FALSE(whole.refused());
  const GlobalOperator refused(room.made.elements, room.made.transport, room.reflectance, {1e-4, 100, whole.bytes()}, room.task);
  EXPECT_TRUE(refused.refused());
  EXPECT_EQ(refused.bytes(), 0U);
}

TEST(WaveletGlobal, TheLossThatIsReportedExplainsAFurnaceNearOne) {
  constexpr float albedo = 0.99F;
  Bouncing room(furnace(albedo));
  const GlobalOperator global(room.made.elements, room.made.transport, room.reflectance, {1e-2, 1000}, room.task);
  const double lost =
      lost_to_compression(room.made.elements, room.made.transport, global, false, room.reflectance, {{}, 10000, 1e-5}, room.task);
  EXPECT_GT(lost, 0.02);
  const std::vector<Rgb> ones(room.made.elements.leaves().size(), Rgb(1.0F));
  const Coefficients<Rgb> even = coefficients_of<Rgb>(room.made.elements, ones);
  const std::vector<Rgb> light = leaf_means_of<Rgb>(
      room.made.elements,
      all_bounces(room.made.elements, room.made.transport, global, false, even, room.reflectance, room.task).irradiance);
  double mean = 0.0, area = 0.0;
  for (std::size_t leaf = 0; leaf < light.size(); ++leaf) {
    const auto weight = static_cast<double>(room.made.elements.nodes()[room.made.elements.leaves()[leaf]].area);
    mean += weight * static_cast<double>(light[leaf].g);
    area += weight;
  }
  const double expected = static_cast<double>(albedo / (1.0F - albedo));
  EXPECT_NEAR(mean / area, expected * (1.0 - lost), 0.02 * expected);
}

}  // namespace
}  // namespace gibench::test
