/// The whole method: furnaces, refusals, budgets, changed materials.
#include <gtest/gtest.h>

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

TEST(WaveletMethod, RefusesWhatHasTooManySides) {
  const auto method = make_session(wavelet_entry(), Parameters(wavelet_entry().schema, SettingTexts{}));
  EXPECT_FALSE(method->refusal(open_corner()));
  EXPECT_TRUE(method->refusal(made::random_triangles(9000, 1.0F, 0.01F, 1)));
}

}  // namespace
}  // namespace gibench::test
