/// The whole method: furnaces, refusals, budgets, changed materials.
#include <gtest/gtest.h>

#include "common/core/error.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "methods/wavelet/wavelet.h"
#include "rooms.h"

namespace gibench::test {
namespace {

struct Solved {
  World world;
  Task task;
  std::unique_ptr<MethodSession> method;
  StageReport prepared, lit;

  Solved(Scene scene, const SettingTexts& settings) : world(std::move(scene)) {
    const MethodEntry entry = wavelet_entry();
    method = make_session(entry, Parameters(entry.schema, settings));
    EffectPlan plan;
    plan.simulated = {Effect::direct, Effect::diffuse_indirect, Effect::occlusion};
    prepared = method->prepare(world, plan, task);
    if (succeeded(prepared.termination)) lit = method->light(Lighting::of(world.scene()), task);
  }
  std::vector<Rgb> indirect(std::size_t count) {
    const std::vector<SurfaceSample> samples = area_uniform_samples(world, count, 3);
    std::vector<Rgb> values(samples.size());
    method->shade({Quantity::irradiance, samples, {}}, {{}, values, {}, {}, {}}, task);
    return values;
  }
};

TEST(WaveletMethod, AFurnaceGivesTheClosedForm) {
  for (const float albedo : {0.3F, 0.6F, 0.9F}) {
    Solved solved(furnace(albedo), {{"leaves", "600"}, {"direct_samples", "16"}, {"residual", "1e-4"}});
    ASSERT_TRUE(succeeded(solved.lit.termination)) << solved.lit.message;
    const float expected = pi * albedo / (1.0F - albedo);
    for (const Rgb& value : solved.indirect(200)) EXPECT_NEAR(value.r, expected, 0.01F * expected);
  }
}

TEST(WaveletMethod, ASmallBudgetMakesACoarserOperatorAndSaysSo) {
  Solved fine(open_corner(), {{"leaves", "600"}}), coarse(open_corner(), {{"leaves", "600"}, {"memory_budget", "1"}});
  EXPECT_TRUE(fine.prepared.message.empty()) << fine.prepared.message;
  ASSERT_TRUE(succeeded(coarse.prepared.termination)) << coarse.prepared.message;
  EXPECT_NE(coarse.prepared.message.find("memory_budget"), std::string::npos);
  EXPECT_LT(coarse.prepared.counters["blocks"], fine.prepared.counters["blocks"]);
}

TEST(WaveletMethod, PowersThatEndTooSoonAreReported) {
  for (const char* mode : {"global", "gathered"}) {
    Solved few(furnace(0.8F), {{"leaves", "24"}, {"mode", mode}, {"powers", "3"}});
    EXPECT_EQ(few.lit.termination, Termination::bound_reached) << mode;
    EXPECT_NE(few.lit.message.find("powers"), std::string::npos) << few.lit.message;
    Solved enough(furnace(0.5F), {{"leaves", "24"}, {"mode", mode}});
    EXPECT_EQ(enough.lit.termination, Termination::done) << enough.lit.message;
  }
  Solved endless(furnace(1.0F), {{"leaves", "24"}, {"mode", "global"}, {"precision", "32"}, {"compression", "0"}});
  EXPECT_EQ(endless.lit.termination, Termination::not_converged) << endless.lit.message;
  EXPECT_NE(endless.lit.message.find("powers"), std::string::npos) << endless.lit.message;
}

TEST(WaveletMethod, AGlobalOperatorBeyondTheBudgetIsReported) {
  Solved solved(furnace(0.8F), {{"leaves", "2000"}, {"mode", "global"}, {"memory_budget", "1"}, {"series_threshold", "0"}});
  EXPECT_EQ(solved.prepared.termination, Termination::out_of_budget);
  EXPECT_NE(solved.prepared.message.find("memory_budget"), std::string::npos) << solved.prepared.message;
}

TEST(WaveletMethod, SamplesOfTheKernelAreAtLeastTwo) {
  EXPECT_THROW(wavelet_settings({{"kernel", "samples"}, {"rays", "1"}}), InputError);
  EXPECT_EQ(wavelet_settings({{"kernel", "samples"}, {"rays", "2"}}).rays, 2);
}

/// Of two faces in one place that which emits shows.
TEST(WaveletMethod, AMaterialThatBeginsToEmitMakesTheElementsAnew) {
  const auto room = [](const Rgb& albedo, const Rgb& emission) {
    made::SceneBuilder builder;
    builder.room("room", builder.diffuse("white", Rgb(0.5F), Rgb(0.1F)), Vec3(0.0F), Vec3(1.0F));
    builder.quad("panel", builder.diffuse("panel", albedo, emission), {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
    return builder.build("room");
  };
  Solved solved(room(Rgb(0.5F), Rgb()), {{"leaves", "100"}});
  const auto elements_after = [&](Scene scene) {
    const World after(std::move(scene));
    const MaterialEdit edit{"panel", after.scene().materials[1]};
    const StageReport report = solved.method->edit(edit, after, Lighting::of(after.scene()), solved.task);
    EXPECT_TRUE(succeeded(report.termination)) << report.message;
    return report.counters["elements"];
  };
  EXPECT_EQ(elements_after(room(Rgb(0.7F), Rgb())), 0U);
  EXPECT_GT(elements_after(room(Rgb(0.7F), Rgb(1.0F))), 0U);
  EXPECT_EQ(elements_after(room(Rgb(0.2F), Rgb(2.0F))), 0U);
  EXPECT_GT(elements_after(room(Rgb(0.2F), Rgb())), 0U);
}

TEST(WaveletMethod, RefusesWhatHasTooManySides) {
  const auto method = make_session(wavelet_entry(), Parameters(wavelet_entry().schema, SettingTexts{}));
  EXPECT_FALSE(method->refusal(open_corner()));
  EXPECT_TRUE(method->refusal(made::random_triangles(9000, 1.0F, 0.01F, 1)));
}

}  // namespace
}  // namespace gibench::test
