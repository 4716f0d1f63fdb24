/// The whole method in each of its modes: energy, convergence to traced visibility, failure modes, bad input.
#include "methods/antiradiance/antiradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/antiradiance/settings.h"
#include "solved_scene.h"

namespace gibench {
namespace {

/// A closed room that glows, albedo ρ, with a block on its floor and one in the air.
Scene furnace(float albedo) {
  made::SceneBuilder builder;
  const std::uint32_t glow = builder.diffuse("glow", Rgb(albedo), Rgb(1.0F));
  builder.room("room", glow, Vec3(0.0F), Vec3(1.0F));
  builder.block("on the floor", glow, {0.2F, 0.0F, 0.2F}, {0.5F, 0.4F, 0.5F});
  builder.block("in the air", glow, {0.55F, 0.5F, 0.5F}, {0.8F, 0.7F, 0.8F}, 30.0F);
  return builder.build("furnace");
}

TEST(Antiradiance, FurnaceNeverGainsEnergy) {
  for (const float albedo : {0.2F, 0.8F})
    for (const char* mode : {"radiosity", "implicit", "antiradiance"}) {
      // Many samples of the direct light: what is looked for is not its noise.
      Solved solved(furnace(albedo), {{"mode", mode}, {"elements", "1500"}, {"bins", "8"}, {"direct_samples", "64"}});
      ASSERT_TRUE(succeeded(solved.lit.termination)) << solved.lit.message;
      // Radiosity π e / (1 − ρ); the first, direct part of the irradiance is π e.
      const double exact = pi_double * static_cast<double>(albedo) / (1.0 - static_cast<double>(albedo));
      const auto samples = solved.samples();
      const auto found = solved.irradiance(samples);
      EXPECT_NEAR(mean(found), exact, 0.05 * exact) << mode << ' ' << albedo;
      // Implicit visibility loses whole bins here and there; values at corners beside such an element swing past the mean.
      const double most = std::string(mode) == "implicit" ? 1.05 : 1.02;
      for (const Rgb& value : found) EXPECT_LE(static_cast<double>(value.g), most * exact) << mode << ' ' << albedo;
    }
}

TEST(Antiradiance, ComesToTracedVisibilityAsBinsAndLinksGrow) {
  const Scene scene = made::box_scene();
  const Setting common{{"elements", "1500"}};
  const auto with = [&](Setting more) {
    more.insert(more.end(), common.begin(), common.end());
    return more;
  };
  Solved traced(scene, with({{"mode", "radiosity"}, {"visibility_rays", "16"}}));
  const auto samples = traced.samples();
  const auto expected = traced.irradiance(samples);
  // Bins finer than the links only show between which bins the links fall: both grow together.
  Solved coarse(scene, with({{"bins", "4"}, {"tolerance", "0.2"}})), fine(scene, with({{"bins", "8"}, {"tolerance", "0.01"}}));
  const double coarse_difference = difference(coarse.irradiance(samples), expected);
  const double fine_difference = difference(fine.irradiance(samples), expected);
  EXPECT_LT(fine_difference, 0.05);
  EXPECT_LT(fine_difference, coarse_difference);
}

/// A lit square, two black sheets above it, and behind both of them a black receiver.
Scene behind_two_sheets() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.8F)), black = builder.diffuse("black", Rgb(0.0F));
  const auto facing_down = [&](const std::string& name, float height, float half) {
    builder.quad(name, black, {{{-half, height, -half}, {half, height, -half}, {half, height, half}, {-half, height, half}}});
  };
  builder.quad("lit", white, {{{-0.5F, 0.0F, 0.5F}, {0.5F, 0.0F, 0.5F}, {0.5F, 0.0F, -0.5F}, {-0.5F, 0.0F, -0.5F}}});
  facing_down("first sheet", 1.0F, 2.0F);
  facing_down("second sheet", 1.5F, 2.0F);
  facing_down("receiver", 2.5F, 0.3F);
  builder.light(PointLight{{0.0F, 0.9F, 0.0F}, Rgb(1.0F)});
  return builder.build("behind two sheets");
}

/// Irradiance on a point that faces down, of light that the lit square reflects and nothing hides.
double unshadowed(const Vec3& point) {
  constexpr int steps = 100;
  double sum = 0.0;
  for (int i = 0; i < steps; ++i)
    for (int k = 0; k < steps; ++k) {
      const Vec3 from((static_cast<float>(i) + 0.5F) / steps - 0.5F, 0.0F, (static_cast<float>(k) + 0.5F) / steps - 0.5F);
      const Vec3 to_light = Vec3(0.0F, 0.9F, 0.0F) - from, d = point - from;
      const double light = static_cast<double>(glm::dot(to_light, to_light)), squared = static_cast<double>(glm::dot(d, d));
      const double irradiance = static_cast<double>(to_light.y) / (light * std::sqrt(light));
      sum += 0.8 * irradiance / pi_double * static_cast<double>(d.y * d.y) / (squared * squared) / (steps * steps);
    }
  return sum;
}

/// What the receiver gets after 1, 2, 3 and all terms, as a share of what it would get if nothing hid the lit square.
std::vector<double> shares_by_term(const char* bins) {
  std::vector<double> shares;
  for (const char* iterations : {"1", "2", "3", "0"}) {
    Solved solved(behind_two_sheets(),
                  {{"elements", "1500"}, {"closure_rays", "0"}, {"iterations", iterations}, {"clamp", "false"}, {"bins", bins}});
    const auto samples = solved.samples_of_object(3, 20000);
    double exact = 0.0;
    for (const SurfaceSample& sample : samples) exact += unshadowed(sample.position) / static_cast<double>(samples.size());
    shares.push_back(mean(solved.irradiance(samples)) / exact);
    EXPECT_EQ(solved.lit.termination, std::string(iterations) == "0" ? Termination::converged : Termination::bound_reached);
  }
  return shares;
}

TEST(Antiradiance, FirstTermHasNoShadowsAndTheSecondTakesTooMuch) {
  // The second term takes the light away once for each sheet: 1 - 2 = -1. The third gives back what the first sheet took from
  // the second: 0, and there is nothing for a fourth to do. Bins smear negative light, by a share that falls with the square of
  // their width, as their masks are bilinear.
  const std::vector<double> coarse = shares_by_term("12"), fine = shares_by_term("24");
  for (const std::vector<double>& shares : {coarse, fine}) {
    EXPECT_NEAR(shares[0], 1.0, 0.01);  // of which discs in place of cells are 0.4%
    EXPECT_NEAR(shares[3], shares[2], 1e-3);
  }
  EXPECT_LT(std::fabs(fine[1] + 1.0), 0.25 * std::fabs(coarse[1] + 1.0));
  EXPECT_LT(std::fabs(fine[3]), 0.25 * std::fabs(coarse[3]));
  EXPECT_NEAR(fine[1], -1.0, 0.05);
  EXPECT_NEAR(fine[3], 0.0, 0.01);
}

TEST(Antiradiance, NegativeAnswersAreClampedAndCounted) {
  Solved solved(behind_two_sheets(), {{"elements", "3000"}, {"closure_rays", "0"}, {"iterations", "2"}});
  const auto samples = solved.samples_of_object(3, 20000);
  for (const Rgb& value : solved.irradiance(samples)) EXPECT_EQ(value, Rgb());
  EXPECT_EQ(solved.shaded.counters["answers_clamped"], samples.size());
}

/// The text's elements and links need no ray; its accessibility blends the first two passes of sides alone.
TEST(Antiradiance, PaperPresetLeavesOutWhatTheTextDoesNotHave) {
  const MethodEntry entry = antiradiance_entry();
  const Setting paper = with_preset(entry.presets, "paper", {{"elements", "300"}});
  for (const char* mode : {"accessibility", "disc-bounce", "implicit", "antiradiance"}) {
    Setting setting = paper;
    setting.emplace_back("mode", mode);
    Solved solved(made::box_scene(), setting);
    EXPECT_TRUE(succeeded(solved.prepared.termination)) << solved.prepared.message;
    EXPECT_EQ(solved.prepared.counters["closest_hit_rays"], 0U) << mode;
    EXPECT_EQ(solved.prepared.counters["occlusion_rays"], 0U) << mode;
  }
  const antiradiance::Settings settings = antiradiance::settings_from(Parameters(entry.schema, paper));
  EXPECT_EQ(settings.passes, 2);
  EXPECT_EQ(settings.sectors, 1);
  EXPECT_EQ(settings.bin_winner, antiradiance::BinWinner::links);
  EXPECT_FALSE(settings.near_cells);
  EXPECT_FALSE(settings.merge);
}

TEST(Antiradiance, ConvexRoomKeepsNoDirectionsAndTracesNoVisibility) {
  made::BoxOptions options;
  options.lamp_emission = Rgb();
  options.lights = {PointLight{{0.5F, 0.8F, 0.5F}, Rgb(1.0F)}};
  for (const bool blocks : {false, true}) {
    options.blocks = blocks;
    Solved directions(made::box_scene(options), {{"elements", "500"}, {"bins", "8"}}),
        traced(made::box_scene(options), {{"mode", "radiosity"}, {"elements", "500"}});
    EXPECT_EQ(directions.prepared.counters["bins"], blocks ? 64U : 0U);
    EXPECT_EQ(directions.prepared.counters["occlusion_rays"], 0U);
    EXPECT_EQ(traced.prepared.counters["occlusion_rays"] > 0U, blocks);
  }
}

/// A room with a black lamp in its ceiling's plane, or so many metres below.
Scene room_with_lamp(float below, bool lamp_first) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F)), lamp = builder.diffuse("lamp", Rgb(0.0F), Rgb(10.0F));
  const auto add_lamp = [&] {
    const float y = 1.0F - below;
    builder.quad("lamp", lamp, {{{0.4F, y, 0.4F}, {0.6F, y, 0.4F}, {0.6F, y, 0.6F}, {0.4F, y, 0.6F}}});
  };
  if (lamp_first) add_lamp();
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  if (!lamp_first) add_lamp();
  return builder.build("room with a lamp");
}

TEST(Antiradiance, LampInTheCeilingsPlaneIsAsOneJustBelow) {
  for (const char* mode : {"radiosity", "antiradiance"}) {
    const Setting setting{{"mode", mode}, {"elements", "600"}, {"bins", "8"}};
    Solved below(room_with_lamp(1e-4F, false), setting);
    std::vector<SurfaceSample> samples = below.samples_of_object(0, 2000);
    std::erase_if(samples, [](const SurfaceSample& sample) {  // above the lamp is inside geometry where it hangs lower
      return sample.position.y > 0.9F && std::fabs(sample.position.x - 0.5F) < 0.11F &&
             std::fabs(sample.position.z - 0.5F) < 0.11F;
    });
    const auto expected = below.irradiance(samples);
    for (const bool lamp_first : {false, true}) {
      Solved flush(room_with_lamp(0.0F, lamp_first), setting);
      std::vector<SurfaceSample> same = samples;
      for (SurfaceSample& sample : same)
        if (lamp_first) ++sample.object, ++sample.face, sample.triangle += 2;
      EXPECT_LT(difference(flush.irradiance(same), expected), 0.03) << mode << ' ' << lamp_first;
    }
  }
}

/// A closed room that a one-sided sheet parts, lit below it.
Scene parted_room() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.quad("sheet", white, {{{0.0F, 0.48F, 0.0F}, {0.0F, 0.48F, 1.0F}, {1.0F, 0.48F, 1.0F}, {1.0F, 0.48F, 0.0F}}});
  builder.light(PointLight{{0.5F, 0.2F, 0.5F}, Rgb(1.0F)});
  return builder.build("parted room");
}

/// Light on the walls just above the sheet, as a share of that just below.
double leak_along_sheet(const char* mode, const char* elements) {
  Solved solved(parted_room(), {{"mode", mode}, {"elements", elements}});
  EXPECT_GT(solved.prepared.counters["elements_parted_by_surfaces"], 0U);
  EXPECT_NE(solved.prepared.message.find("cross"), std::string::npos) << solved.prepared.message;
  std::vector<SurfaceSample> above, below;
  for (const SurfaceSample& sample : solved.samples(20000)) {
    if (sample.object != 0 || std::fabs(sample.normal.y) > 0.5F) continue;
    if (sample.position.y > 0.48F && sample.position.y < 0.6F) above.push_back(sample);
    if (sample.position.y < 0.48F && sample.position.y > 0.36F) below.push_back(sample);
  }
  return mean(solved.irradiance(above)) / mean(solved.irradiance(below));
}

TEST(Antiradiance, NoLightLeaksAlongASheetThatPartsARoom) {
  // Above and below are two spaces: no link joins them, however large its nodes are beside the elements.
  for (const char* elements : {"400", "3200"}) EXPECT_LT(leak_along_sheet("radiosity", elements), 1e-6) << elements;
  // Negative light leaks where elements lie beside the sheet: half as much where their edges are half as long, but for walls
  // being cut into whole numbers of rows, of which some ten lie along the sheet: a tenth of the leak either way.
  const double coarse = leak_along_sheet("antiradiance", "400"), fine = leak_along_sheet("antiradiance", "1600");
  EXPECT_LT(coarse, 0.1);
  EXPECT_LT(fine, 0.5 * 1.1 * coarse);
}

TEST(Antiradiance, SlabsThinnerThanAnElementAreReported) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, Vec3(0.0F), Vec3(1.0F));
  builder.block("slab", white, {0.2F, 0.5F, 0.2F}, {0.8F, 0.51F, 0.8F});
  builder.light(PointLight{{0.5F, 0.2F, 0.5F}, Rgb(1.0F)});
  const Scene scene = builder.build("thin slab");
  Solved solved(scene, {{"elements", "400"}, {"bins", "4"}}), traced(scene, {{"mode", "radiosity"}, {"elements", "400"}});
  EXPECT_GT(solved.prepared.counters["elements_on_thin_slabs"], 10U);
  EXPECT_NE(solved.prepared.message.find("behind them"), std::string::npos) << solved.prepared.message;
  EXPECT_EQ(traced.prepared.counters["elements_on_thin_slabs"], 0U);  // rays tell such surfaces apart
}

TEST(Antiradiance, WhatDoesNotFitIsRefusedBeforeAnyRay) {
  Scene scene = made::random_triangles(2000, 1.0F, 0.1F, 1);
  scene.lights = {PointLight{Vec3(0.5F), Rgb(1.0F)}};
  Solved solved(std::move(scene), {{"elements", "100"}, {"memory_budget", "4"}, {"merge", "false"}});
  EXPECT_EQ(solved.prepared.termination, Termination::out_of_budget);
  EXPECT_NE(solved.prepared.message.find("memory_budget"), std::string::npos) << solved.prepared.message;
  EXPECT_NE(solved.prepared.message.find("where 100 were asked for"), std::string::npos) << solved.prepared.message;
  EXPECT_EQ(solved.prepared.counters["closest_hit_rays"], 0U);
}

/// Two rooms that glow, joined by a slit in the wall between them.
Scene joined_furnaces() {
  made::SceneBuilder builder;
  const std::uint32_t glow = builder.diffuse("glow", Rgb(0.8F), Rgb(1.0F));
  builder.room("rooms", glow, Vec3(0.0F), {2.1F, 1.0F, 1.0F});
  builder.block("wall on the left", glow, {1.0F, 0.0F, 0.0F}, {1.1F, 1.0F, 0.42F});
  builder.block("wall on the right", glow, {1.0F, 0.0F, 0.58F}, {1.1F, 1.0F, 1.0F});
  return builder.build("joined furnaces");
}

/// No iteration may bring more than there is, whatever the bins: cut off after any term, or run to the end.
TEST(Antiradiance, FurnaceNeverGainsEnergyAtAnyIterationAndBins) {
  constexpr double albedo = 0.8;
  const double exact = pi_double * albedo / (1.0 - albedo);
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("glow", Rgb(0.8F), Rgb(1.0F)), Vec3(0.0F), Vec3(1.0F));
  const Scene cube = builder.build("furnace of a cube"), irregular = furnace(0.8F), joined = joined_furnaces();
  for (const Scene* scene : {&cube, &irregular, &joined})
    for (const char* bins : {"4", "8", "12"})
      for (const char* iterations : {"1", "2", "3", "5", "0"}) {
        Solved solved(*scene, {{"elements", "500"}, {"bins", bins}, {"iterations", iterations}, {"tolerance", "0.02"}});
        ASSERT_TRUE(succeeded(solved.lit.termination)) << solved.lit.message;
        const std::string what = scene->name + ", bins " + bins + ", iterations " + iterations;
        double most = 0.0;
        const auto found = solved.irradiance(solved.samples(1000));
        for (const Rgb& value : found) most = std::max(most, static_cast<double>(value.g));
        // Along the wall between the rooms interpolated values swing past their cells' means: there the mean is held.
        EXPECT_LE(scene == &joined ? mean(found) : most, 1.02 * exact) << what;
        if (scene == &cube && std::string(iterations) == "0") {
          EXPECT_NEAR(mean(found), exact, 0.02 * exact) << what;
        }
      }
}

/// Twelve sheets in line above a lit square: with all bounces at once light grows without end (bin_transport_test.cpp).
TEST(Antiradiance, ManySurfacesInLineConvergeBounceByBounce) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  for (int i = 0; i < 12; ++i) {
    const float y = 0.3F + 0.2F * static_cast<float>(i);
    builder.quad("sheet " + std::to_string(i), white, {{{0.0F, y, 0.0F}, {1.0F, y, 0.0F}, {1.0F, y, 1.0F}, {0.0F, y, 1.0F}}});
  }
  builder.quad("lit", white, {{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}}});
  builder.light(PointLight{{0.5F, 0.2F, 0.5F}, Rgb(1.0F)});
  const Scene scene = builder.build("sheets in line");
  Solved solved(scene, {{"elements", "600"}}), traced(scene, {{"mode", "radiosity"}, {"elements", "600"}});
  ASSERT_TRUE(succeeded(solved.lit.termination)) << solved.prepared.message << solved.lit.message;
  EXPECT_NE(solved.lit.message.find("bounce by bounce"), std::string::npos) << solved.lit.message;
  const auto samples = solved.samples();
  EXPECT_LT(difference(solved.irradiance(samples), traced.irradiance(samples)), 0.2);
}

TEST(Antiradiance, SceneOfManySheetsEndsInSuccessOrAClearReport) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.95F));
  for (int i = 0; i < 24; ++i) {
    const float y = 0.01F * static_cast<float>(i), t = 0.002F * static_cast<float>(i % 5);
    builder.quad("sheet " + std::to_string(i), white,
                 {{{0.0F, y, 1.0F}, {1.0F, y + t, 1.0F}, {1.0F, y, 0.0F}, {0.0F, y + t, 0.0F}}}, true);
  }
  builder.light(PointLight{{0.5F, 0.05F, 1.5F}, Rgb(1.0F)});
  Solved solved(builder.build("sheets"), {{"elements", "1500"}, {"bins", "4"}, {"tolerance", "0.05"}});
  if (succeeded(solved.lit.termination)) {
    // The light is half a metre away: 4 W/m² at most, of which bounces between walls of 0.95 make at most 19 times as much.
    const auto found = solved.irradiance(solved.samples(500));
    for (const Rgb& value : found) EXPECT_LT(value.g, 4.0F * 0.95F / 0.05F);
    EXPECT_GT(mean(found), 0.0);
  } else {
    EXPECT_EQ(solved.lit.termination, Termination::not_converged);
    EXPECT_NE(solved.lit.message.find("BiCGSTAB"), std::string::npos) << solved.lit.message;
  }
}

}  // namespace
}  // namespace gibench
