#include "methods/spectral/relighting.h"

#include <gtest/gtest.h>

#include <cmath>

#include "rooms.h"

namespace gibench::test {
namespace {

using namespace spectral;

constexpr float albedo = 0.6F;

std::vector<Rgb4> everywhere(const SpectralRoom& room, const Rgb& value) { return std::vector<Rgb4>(room.slots(), value); }

SpectralRoom small_room(std::vector<std::pair<std::string, std::string>> more = {}, TransferWish wish = {}) {
  more.insert(more.end(), {{"vertices", "800"}, {"part_vertices", "200"}, {"basis_functions", "100"}, {"rays", "256"}});
  return SpectralRoom(closed_room(), std::move(more), std::move(wish));
}

TEST(SpectralRelighting, FurnaceIsTheGeometricSeries) {
  SpectralRoom room = small_room();
  // Direct irradiance 1 everywhere: the bounces bring ρ + ρ² + … = ρ/(1 − ρ).
  const Relit relit = relight(room.transfer(), everywhere(room, Rgb(1.0F)), everywhere(room, Rgb(albedo / pi)), {}, room.task);
  EXPECT_EQ(relit.termination, Termination::converged);
  for (const Rgb4& value : relit.irradiance) EXPECT_NEAR(value.r, albedo / (1.0F - albedo), 0.01F * albedo / (1.0F - albedo));
}

TEST(SpectralRelighting, BoundedBouncesAreThePartialSums) {
  SpectralRoom room = small_room();
  float expected = 0.0F;
  for (int bounces = 1; bounces <= 4; ++bounces) {
    expected = albedo * (1.0F + expected);
    const Relit relit = relight(room.transfer(), everywhere(room, Rgb(1.0F)), everywhere(room, Rgb(albedo / pi)),
                                {.planned = bounces, .most = 1000, .residual = 1e-9}, room.task);
    EXPECT_EQ(relit.termination, Termination::bound_reached);
    EXPECT_EQ(relit.bounces, bounces);
    for (const Rgb4& value : relit.irradiance) EXPECT_NEAR(value.r, expected, 0.01F * expected);
  }
}

TEST(SpectralRelighting, BlackSurfacesEndAtOnceAndWhiteOnesAreTold) {
  SpectralRoom room = small_room();
  const Relit black = relight(room.transfer(), everywhere(room, Rgb(1.0F)), everywhere(room, Rgb()), {}, room.task);
  EXPECT_EQ(black.bounces, 1);
  for (const Rgb4& value : black.irradiance) EXPECT_EQ(value.r, 0.0F);
  const Relit white = relight(room.transfer(), everywhere(room, Rgb(1.0F)), everywhere(room, Rgb(1.0F / pi)),
                              {.planned = {}, .most = 50}, room.task);
  EXPECT_FALSE(succeeded(white.termination) && white.message.empty());
}

TEST(SpectralRelighting, FixedAlbedosGiveWhatTheBouncesGive) {
  for (const std::optional<int> bound : {std::optional<int>(2), std::optional<int>()}) {
    SpectralRoom free = small_room({{"compression_error", "0"}});
    TransferWish wish;
    wish.reflectance.assign(2, Rgb(0.6F, 0.3F, 0.1F) / pi);
    wish.most_bounces = bound.value_or(0);
    SpectralRoom fixed = small_room({{"compression_error", "0"}, {"mode", "fixed_albedo"}}, wish);
    ASSERT_EQ(fixed.transfer().all_bounces.size(), 3U);
    std::vector<Rgb4> light, reflectance = everywhere(free, wish.reflectance[0]);
    for (const std::uint32_t node : free.transfer().node_of_slot) light.emplace_back(Rgb(free.transfer().nodes[node].position.y));
    const Relit one = relight(free.transfer(), light, reflectance, {.planned = bound, .most = 1000, .residual = 1e-8}, free.task);
    const Relit other = relight(fixed.transfer(), light, reflectance, {.planned = bound, .most = 1000}, fixed.task);
    for (std::uint32_t slot = 0; slot < free.slots(); ++slot)
      for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(Rgb(other.irradiance[slot])[c], Rgb(one.irradiance[slot])[c], 1e-3F * Rgb(one.irradiance[slot])[c]);
  }
}

TEST(SpectralRelighting, FixedAlbedosGiveTheGlossyFinalBounceAsManyBouncesAsThePlanDoes) {
  for (const std::optional<int> bound : {std::optional<int>(1), std::optional<int>(2), std::optional<int>()}) {
    TransferWish wish;
    wish.glossy_objects = {false, true};
    wish.reflectance.assign(2, Rgb(0.6F, 0.3F, 0.1F) / pi);
    wish.most_bounces = bound.value_or(0);
    SpectralRoom free = small_room({{"compression_error", "0"}}, wish);
    SpectralRoom fixed = small_room({{"compression_error", "0"}, {"mode", "fixed_albedo"}}, wish);
    std::vector<Rgb4> light, reflectance = everywhere(free, wish.reflectance[0]);
    for (const std::uint32_t node : free.transfer().node_of_slot) light.emplace_back(Rgb(free.transfer().nodes[node].position.y));
    const Relit one = relight(free.transfer(), light, reflectance, {.planned = bound, .most = 1000, .residual = 1e-8}, free.task);
    const Relit other = relight(fixed.transfer(), light, reflectance, {.planned = bound, .most = 1000}, fixed.task);
    ASSERT_EQ(other.harmonics.size(), one.harmonics.size());
    ASSERT_FALSE(one.harmonics.empty());
    for (std::size_t row = 0; row < one.harmonics.size(); ++row)
      for (std::size_t k = 0; k < harmonic_count; ++k)
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(other.harmonics[row][k][c], one.harmonics[row][k][c], 2e-3F * one.harmonics[row][0][c]);
  }
}

TransferMaking white_room(std::vector<std::pair<std::string, std::string>> more, int most_bounces) {
  TransferWish wish;
  wish.reflectance.assign(2, Rgb(1.0F / pi));
  wish.most_bounces = most_bounces;
  more.emplace_back("mode", "fixed_albedo");
  return std::move(small_room(std::move(more), wish).made);
}

TEST(SpectralRelighting, FixedAlbedosOfWhiteSurfacesHaveNoSumThatIsKnown) {
  for (const char* error : {"0", "0.01"}) {
    const TransferMaking unbounded = white_room({{"compression_error", error}}, 0),
                         bounded = white_room({{"compression_error", error}}, 3);
    EXPECT_EQ(unbounded.termination, Termination::not_converged);
    EXPECT_NE(unbounded.message.find("mode=bounces"), std::string::npos) << unbounded.message;
    EXPECT_TRUE(unbounded.transfer.all_bounces.empty());
    EXPECT_EQ(bounded.termination, Termination::done) << bounded.message;
    EXPECT_EQ(bounded.transfer.all_bounces.size(), 1U);
  }
}

TEST(SpectralRelighting, FixedAlbedosTellHowFarErrorsOfTheMatrixCount) {
  TransferWish wish;
  wish.reflectance.assign(2, Rgb(0.95F / pi));
  const SpectralRoom bright = small_room({{"mode", "fixed_albedo"}}, wish);
  EXPECT_EQ(bright.made.termination, Termination::done);
  // Of constant light, which a closed room of one albedo keeps longest, 0.95 stays: 1 / (1 - 0.95).
  EXPECT_NE(bright.made.message.find("up to 20 times"), std::string::npos) << bright.made.message;
  wish.reflectance.assign(2, Rgb(0.5F / pi));
  EXPECT_EQ(small_room({{"mode", "fixed_albedo"}}, wish).made.message, "");
}

TEST(SpectralRelighting, TooManyColumnsToFoldAreRefusedBeforeTheWork) {
  TransferWish wish;
  const std::vector<std::pair<std::string, std::string>> settings{
      {"mode", "fixed_albedo"}, {"vertices", "1"}, {"nodes", "vertices"}, {"rays", "1"}};
  // Loose triangles are parts of their own, each with a column.
  wish.reflectance.assign(1, Rgb(0.1F));
  const SpectralRoom loose(made::random_triangles(8300, 10.0F, 0.1F, 3), settings, wish);
  EXPECT_EQ(loose.made.termination, Termination::out_of_budget);
  for (const char* word : {"mode=fixed_albedo", "basis_functions", "8192", "83"})
    EXPECT_NE(loose.made.message.find(word), std::string::npos) << loose.made.message;
}

TEST(SpectralRelighting, GreySurfacesShareOneFoldedMatrix) {
  TransferWish wish;
  wish.reflectance.assign(2, Rgb(0.1F));
  SpectralRoom room = small_room({{"mode", "fixed_albedo"}}, wish);
  EXPECT_EQ(room.transfer().all_bounces.size(), 1U);
}

TEST(SpectralRelighting, HarmonicsOfAFurnaceAreThoseOfAHemisphere) {
  TransferWish wish;
  wish.glossy_objects = {false, true};
  SpectralRoom room = small_room({}, wish);
  const Relit relit = relight(room.transfer(), everywhere(room, Rgb(1.0F)), everywhere(room, Rgb(albedo / pi)), {}, room.task);
  // Light L from all sides: ∫ L h_k cos is π h_0 L for the constant, and points along the normal for the linear ones, 2π/3 of it.
  const float light = albedo / (1.0F - albedo) / pi;
  ASSERT_EQ(relit.harmonics.size(), room.transfer().glossy_slots.size());
  for (std::size_t row = 0; row < relit.harmonics.size(); ++row) {
    const Vec3& n = room.transfer().node_at(room.transfer().glossy_slots[row]).normal;
    const auto& h = relit.harmonics[row];
    EXPECT_NEAR(h[0].r, 0.282095F * pi * light, 0.02F * light);
    const float linear = 0.488603F * 2.0F * pi / 3.0F * light;
    EXPECT_NEAR(h[1].r, linear * n.y, 0.03F * light);
    EXPECT_NEAR(h[2].r, linear * n.z, 0.03F * light);
    EXPECT_NEAR(h[3].r, linear * n.x, 0.03F * light);
  }
}

}  // namespace
}  // namespace gibench::test
