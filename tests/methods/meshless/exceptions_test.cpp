/// What the method says of its own answers, what it refuses, and the algorithm of the text.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/methods/meshless/solved.h"

namespace gibench::test {
namespace {

TEST(Meshless, TooManyPointsAreRefusedByTheParametersName) {
  const Solved solved(made::box_scene(), 2, {{"levels", "12"}});
  EXPECT_EQ(solved.prepared.termination, Termination::out_of_budget);
  EXPECT_NE(solved.prepared.message.find("levels=12"), std::string::npos) << solved.prepared.message;
}

/// The text's algorithm, on fewer levels than its constants say.
TEST(Meshless, ThePapersOwnAlgorithmAgreesInAFurnace) {
  Solved solved(furnace(Rgb(0.5F)), std::nullopt,
                with_preset(meshless_entry().presets, "paper", {{"levels", "2"}, {"basis_direct_samples", "1024"}}));
  ASSERT_TRUE(succeeded(solved.lit.termination)) << solved.lit.message;
  EXPECT_EQ(solved.lit.counters["undecided_samples"], 0U);
  const std::vector<SurfaceSample> samples = area_uniform_samples(solved.world(), 200, 3);
  // Radiance 1 / (1 - 0.5) from all sides; direct light comes from the basis, too.
  for (const Rgb& value : solved.irradiance(samples, Component::total)) EXPECT_NEAR(value.r, 2.0F * pi, 0.03F * 2.0F * pi);
}

/// Counters of the light at samples all over a scene.
Counters shade_counters(const Scene& scene, const Setting& settings) {
  Solved solved(scene, 1, settings);
  solved.irradiance(area_uniform_samples(solved.world(), 600, 3), Component::total);
  return solved.shaded.counters;
}

TEST(Meshless, CountsPlacesWhereItsFunctionsReachPastASurface) {
  const auto room_with = [](const std::function<void(made::SceneBuilder&, std::uint32_t)>& add) {
    made::SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
    builder.room("room", white, {0, 0, 0}, {1, 1, 1});
    add(builder, white);
    builder.light(PointLight{{0.5F, 0.8F, 0.5F}, Rgb(1.0F)});
    return builder.build("room");
  };
  const Scene bare = room_with([](made::SceneBuilder&, std::uint32_t) {});
  const Scene parted = room_with([](made::SceneBuilder& builder, std::uint32_t white) {  // by one sheet
    builder.quad("sheet", white, {{{0, 0.48F, 0}, {0, 0.48F, 1}, {1, 0.48F, 1}, {1, 0.48F, 0}}});
  });
  const Scene slab = room_with([](made::SceneBuilder& builder, std::uint32_t white) {  // two-sided, a millimetre thick
    builder.quad("below", white, {{{0.2F, 0.3F, 0.2F}, {0.8F, 0.3F, 0.2F}, {0.8F, 0.3F, 0.8F}, {0.2F, 0.3F, 0.8F}}}, true);
    builder.quad("above", white, {{{0.2F, 0.301F, 0.2F}, {0.2F, 0.301F, 0.8F}, {0.8F, 0.301F, 0.8F}, {0.8F, 0.301F, 0.2F}}},
                 true);
  });
  const Setting settings{{"levels", "3"}, {"rays", "64"}, {"coarsest_rays", "64"}, {"groups", "objects"}, {"cut_levels", "0"}};
  EXPECT_EQ(shade_counters(bare, settings)["crossed_samples"], 0U);
  EXPECT_GT(shade_counters(bare, settings)["tried_samples"], 500U);
  const std::uint64_t crossed = shade_counters(parted, settings)["crossed_samples"];
  EXPECT_GT(crossed, 20U);
  Setting cutting = settings;
  cutting.back().second = "2";
  EXPECT_LT(shade_counters(parted, cutting)["crossed_samples"], crossed / 2)
      << "functions that end at the sheet do not reach past it";
  Scene one = slab;
  for (Object& object : one.objects) object.group = "all";
  EXPECT_GT(shade_counters(one, settings)["crossed_samples"], 20U);
}

TEST(Meshless, CountsNoCrossingsOnBentSurfaces) {
  // Twelve-sided columns that stand free, and the inside of one: no function is cut by the surface itself.
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F), Rgb(1.0F));
  std::vector<Vec3> ring;
  std::vector<std::array<std::uint32_t, 4>> outward, inward;
  constexpr std::uint32_t sides = 12;
  for (std::uint32_t i = 0; i < sides; ++i)
    for (const float y : {0.0F, 1.0F}) {
      const float angle = 2.0F * pi * static_cast<float>(i) / sides;
      ring.emplace_back(0.3F * std::cos(angle), y, 0.3F * std::sin(angle));
    }
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t a = 2 * i, b = 2 * ((i + 1) % sides);
    outward.push_back({a, a + 1, b + 1, b});
    inward.push_back({b, b + 1, a + 1, a});
  }
  std::vector<Vec3> elsewhere = ring;
  for (Vec3& v : elsewhere) v.x += 2.0F;
  builder.object("column", white, ring, outward).object("pipe", white, elsewhere, inward);
  builder.room("room", white, {-1, -1, -1}, {3, 2, 1});
  const Counters counters = shade_counters(builder.build("columns"), rough);
  EXPECT_GT(counters["tried_samples"], 500U);
  EXPECT_EQ(counters["crossed_samples"], 0U);
}

TEST(Meshless, CountsLightThatItClampsToZeroAndPointsInsideGeometry) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F));
  builder.room("room", white, {0, 0, 0}, {1, 1, 1});
  builder.block("block", white, {0.3F, -0.2F, 0.3F}, {0.7F, 0.2F, 0.7F});  // sunk into the floor
  builder.light(SpotLight{{0.5F, 0.9F, 0.5F}, {0.0F, -1.0F, 0.0F}, Rgb(1.0F), 0.995F, 0.99F});
  const Counters counters = shade_counters(builder.build("sunk block"),
                                           {{"levels", "4"}, {"rays", "64"}, {"coarsest_rays", "64"}, {"direct", "basis"}});
  EXPECT_GT(counters["clamped_samples"], 0U) << "the rim of a spot rings";
  EXPECT_GT(counters["inside_samples"], 5U) << "the floor under the block, and the block's lower half";
}

}  // namespace
}  // namespace gibench::test
