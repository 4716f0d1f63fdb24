/// The whole method in each of its modes: energy, convergence to traced visibility, failure modes, bad input.
#include "methods/antiradiance/antiradiance.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

using Setting = std::vector<std::pair<std::string, std::string>>;

class Solved {
 public:
  Solved(Scene scene, Setting settings) : world_(std::move(scene)) {
    const MethodEntry entry = antiradiance_entry();
    method_ = make_session(entry, Parameters(entry.schema, settings));
    const EffectPlan plan = plan_effects(analyse_effects(world_), method_->capabilities().effects);
    prepared = method_->prepare(world_, plan, task_);
    if (succeeded(prepared.termination)) lit = method_->light(Lighting::of(world_.scene()), task_);
  }
  std::vector<Rgb> irradiance(const std::vector<SurfaceSample>& samples) {
    std::vector<Rgb> indirect(samples.size());
    const StageReport report = method_->shade({Quantity::irradiance, samples, {}}, {{}, indirect, {}, {}, {}}, task_);
    EXPECT_TRUE(succeeded(report.termination)) << report.message;
    return indirect;
  }
  std::vector<SurfaceSample> samples(std::size_t count = 2000) const { return area_uniform_samples(world_, count, 5); }
  const World& world() const { return world_; }
  StageReport prepared, lit;

 private:
  World world_;
  Task task_;
  std::unique_ptr<MethodSession> method_;
};

double mean(const std::vector<Rgb>& values) {
  double sum = 0.0;
  for (const Rgb& value : values) sum += static_cast<double>(value.g);
  return sum / static_cast<double>(values.size());
}

/// Root of the mean squared difference, over the mean of the second.
double difference(const std::vector<Rgb>& a, const std::vector<Rgb>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(static_cast<double>(a[i].g - b[i].g), 2.0);
  return std::sqrt(sum / static_cast<double>(a.size())) / mean(b);
}

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
      Solved solved(furnace(albedo), {{"mode", mode}, {"elements", "1500"}, {"bins", "8"}});
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

TEST(Antiradiance, FirstTermHasNoShadowsAndTheSecondTakesTooMuch) {
  const Scene scene = made::box_scene();
  std::vector<double> means;
  std::vector<SurfaceSample> samples;
  for (const char* iterations : {"1", "2", "0"}) {
    Solved solved(scene, {{"elements", "1500"}, {"iterations", iterations}, {"clamp", "false"}});
    if (samples.empty()) samples = solved.samples();
    const auto values = solved.irradiance(samples);
    means.push_back(mean(values));
    EXPECT_EQ(solved.lit.termination, std::string(iterations) == "0" ? Termination::converged : Termination::bound_reached);
  }
  // One bounce unshadowed against all bounces shadowed: the second term brings a bounce and takes shadows.
  EXPECT_NE(means[0], means[1]);
  EXPECT_GT(means[2], 0.0);
}

TEST(Antiradiance, ConvexRoomKeepsNoDirectionsAndTracesNoVisibility) {
  made::BoxOptions options;
  options.blocks = false;
  options.lamp_emission = Rgb();
  options.lights = {PointLight{{0.5F, 0.8F, 0.5F}, Rgb(1.0F)}};
  Solved solved(made::box_scene(options), {{"elements", "1000"}});
  EXPECT_EQ(solved.prepared.counters["bins"], 0U);
  EXPECT_EQ(solved.prepared.counters["occlusion_rays"], 0U);
}

/// A bright wall, a receiver before it, and between them a plate much smaller than a bin.
Scene small_blocker(float shift) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.8F)), black = builder.diffuse("black", Rgb(0.0F));
  builder.quad("receiver", white, {{{0.4F, 0.0F, 0.6F}, {0.6F, 0.0F, 0.6F}, {0.6F, 0.0F, 0.4F}, {0.4F, 0.0F, 0.4F}}});
  builder.quad("bright", white, {{{0.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 0.0F}, {1.0F, 1.0F, 1.0F}, {0.0F, 1.0F, 1.0F}}});
  // Nine specks: a thousandth of the area that they hide.
  for (int i = 0; i < 9; ++i) {
    const float x = 0.38F + 0.12F * static_cast<float>(i % 3) + shift, z = 0.38F + 0.12F * static_cast<float>(i / 3), s = 0.002F;
    builder.quad("speck " + std::to_string(i), black, {{{x, 0.5F, z}, {x + s, 0.5F, z}, {x + s, 0.5F, z + s}, {x, 0.5F, z + s}}});
  }
  builder.light(PointLight{{0.5F, 0.45F, 0.9F}, Rgb(1.0F)});
  return builder.build("small blocker");
}

TEST(ImplicitVisibility, LetsASpeckHideAWall) {
  const Setting implicit{{"mode", "implicit"}, {"elements", "800"}, {"bins", "8"}, {"bin_winner", "links"}},
      radiosity{{"mode", "radiosity"}, {"elements", "800"}};
  const auto lost = [&](float shift) {
    Solved traced(small_blocker(shift), radiosity), nearest(small_blocker(shift), implicit);
    std::vector<SurfaceSample> samples;
    for (const SurfaceSample& sample : traced.samples(4000))
      if (sample.object == 0) samples.push_back(sample);
    return 1.0 - mean(nearest.irradiance(samples)) / mean(traced.irradiance(samples));
  };
  // The specks hide a thousandth; the bins that they are nearest in are lost as a whole.
  const double here = lost(0.0F);
  EXPECT_GT(here, 0.05);
  // And as they move by a twentieth, other bins are lost: what a moving blocker does flickers.
  EXPECT_GT(std::fabs(lost(0.05F) - here), 0.005);
}

TEST(ImplicitVisibility, ComesToTracedVisibilityAsBinsGrow) {
  const Scene scene = made::box_scene();
  Solved traced(scene, {{"mode", "radiosity"}, {"elements", "800"}, {"visibility_rays", "16"}});
  const auto samples = traced.samples();
  const auto expected = traced.irradiance(samples);
  for (const char* winner : {"middle", "links"}) {
    std::vector<double> differences;
    for (const char* bins : {"8", "16", "24"}) {
      Solved nearest(scene, {{"mode", "implicit"}, {"elements", "800"}, {"bins", bins}, {"bin_winner", winner}});
      differences.push_back(difference(nearest.irradiance(samples), expected));
    }
    EXPECT_LT(differences[1], differences[0]) << winner;
    EXPECT_LT(differences[2], differences[1]) << winner;
    EXPECT_LT(differences[2], std::string(winner) == "middle" ? 0.06 : 0.2) << winner;
  }
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
    for (const Rgb& value : solved.irradiance(solved.samples(500))) EXPECT_TRUE(is_finite(value));
  } else {
    EXPECT_EQ(solved.lit.termination, Termination::not_converged);
    EXPECT_NE(solved.lit.message.find("BiCGSTAB"), std::string::npos) << solved.lit.message;
  }
}

}  // namespace
}  // namespace gibench
