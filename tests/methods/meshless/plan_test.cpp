/// How meshless radiosity obeys its plan.
#include <gtest/gtest.h>

#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/meshless/coefficients.h"
#include "methods/meshless/expansion.h"
#include "methods/meshless/meshless.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench {
namespace {

struct Outcome {
  std::vector<Rgb> indirect;
  Counters counters;
  std::size_t bytes = 0;
};

Outcome run(const Scene& scene, const PlanLimits& limits = {}) {
  const World world(scene, 1);
  const MethodEntry entry = meshless_entry();
  // Without looks at the surroundings for the size of discs, and without small light left to chance, which saves shadow rays
  // where there are any: so that only what a plan leaves out differs.
  const auto method = make_session(entry, Parameters(entry.schema, {{"levels", "3"},
                                                                    {"coarsest_samples", "100"},
                                                                    {"rays", "128"},
                                                                    {"coarsest_rays", "128"},
                                                                    {"feature_radius", "0"},
                                                                    {"small_light", "0"}}));
  const EffectPlan plan = plan_effects(analyse_effects(world, limits), effects_of(method->capabilities()));
  Task task;
  EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
  EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
  const auto samples = area_uniform_samples(world, 40, 5);
  Outcome outcome{std::vector<Rgb>(samples.size()), {}, method->bytes()};
  std::vector<Rgb> direct(samples.size());
  EXPECT_TRUE(
      succeeded(method->shade({Quantity::irradiance, samples, {}}, {direct, outcome.indirect, {}, {}, {}}, task).termination));
  outcome.counters = task.counters();
  return outcome;
}

Scene room(const Rgb& albedo, const Rgb& emission) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("wall", albedo, emission), {0, 0, 0}, {1, 1, 1});
  return builder.build("room");
}

TEST(MeshlessPlan, AConvexRoomTakesNoVisibilityRayAndNoTestForPointsInside) {
  PlanLimits forced;
  forced.forced = {Effect::occlusion};
  const Scene scene = room({0.5F, 0.4F, 0.3F}, Rgb(1.0F));
  const Outcome planned = run(scene), all = run(scene, forced);
  EXPECT_EQ(planned.counters["occlusion_rays"], 0U);
  EXPECT_GT(all.counters["occlusion_rays"], 0U);
  const std::uint64_t gathers = planned.counters["samples_gathered"] * 128U;
  EXPECT_EQ(planned.counters["closest_hit_rays"], gathers) << "gathers look for senders, and nothing else does";
  for (std::size_t i = 0; i < planned.indirect.size(); ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(planned.indirect[i][c], all.indirect[i][c], 1e-3F * all.indirect[i][c]);
}

TEST(MeshlessPlan, AGreySceneKeepsOneChannelAndTracesTheSameRays) {
  const Outcome grey = run(room(Rgb(0.5F), Rgb(1.0F))), coloured = run(room(Rgb(0.5F), {1.0F, 1.0F, 0.999F}));
  EXPECT_EQ(grey.counters["channels"], 1U);
  EXPECT_EQ(coloured.counters["channels"], 3U);
  EXPECT_LT(grey.bytes, coloured.bytes);
  EXPECT_LE(grey.counters["closest_hit_rays"], coloured.counters["closest_hit_rays"]);
  // Lamps are drawn by power, which the other blue changes by a rounding step: a sample in a thousand may fall on another
  // triangle.
  for (std::size_t i = 0; i < grey.indirect.size(); ++i)
    EXPECT_NEAR(grey.indirect[i].r, coloured.indirect[i].r, 1e-3F * grey.indirect[i].r);
}

TEST(MeshlessPlan, OneChannelIsAThirdOfTheCoefficients) {
  const meshless::test::BasisScene scene(made::box_scene());
  meshless::Coefficients one(scene.hierarchy, 1), three(scene.hierarchy);
  const std::size_t empty = one.bytes();
  for (std::uint32_t point = 0; point < scene.hierarchy.size(); ++point) one.set(point, Rgb(0.5F)), three.set(point, Rgb(0.5F));
  EXPECT_LT(one.bytes() - empty, three.bytes() - empty);
  const meshless::Place at = scene.hierarchy.place(7);
  const meshless::Expansion flat(one), full(three);
  EXPECT_EQ(flat.evaluate(at), full.evaluate(at));
  EXPECT_LT(flat.bytes(), full.bytes());
}

TEST(MeshlessPlan, ABlackRoomAndADarkOneTakeNoWork) {
  made::BoxOptions black, dark;
  black.floor_albedo = black.left_albedo = black.right_albedo = Rgb();
  dark.lamp_emission = Rgb();
  EXPECT_EQ(run(made::box_scene(black)).counters["samples"], 0U);
  const Outcome unlit = run(made::box_scene(dark));
  EXPECT_EQ(unlit.counters["samples"] + unlit.counters["closest_hit_rays"] + unlit.counters["occlusion_rays"], 0U);
  EXPECT_EQ(unlit.bytes, 0U);
}

TEST(MeshlessPlan, ItsLightPathsFollowItsPlan) {
  const auto method_with = [](const std::string& direct) {
    const MethodEntry entry = meshless_entry();
    return make_session(entry, Parameters(entry.schema, {{"direct", direct}}));
  };
  EffectPlan plan;
  plan.called_for = {Effect::direct, Effect::diffuse_indirect, Effect::glossy_final_bounce, Effect::glossy_chain};
  plan.simulated = {Effect::direct, Effect::diffuse_indirect};
  plan.missing = {Effect::glossy_final_bounce, Effect::glossy_chain};
  plan.max_bounces = 4;
  EXPECT_EQ(method_with("shared")->light_paths(plan), "C.{0,1}[LOB]|CDD{1,4}[LOB]");
  EXPECT_EQ(method_with("basis")->light_paths(plan), "CD{0,1}[LOB]|CDD{1,4}[LOB]");
}

}  // namespace
}  // namespace gibench
