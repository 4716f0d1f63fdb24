#include "common/effects/scene_effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/scene_builder.h"

namespace gibench {
namespace {

using test::box_scene;
using test::BoxOptions;
using test::SceneBuilder;
using testing::HasSubstr;

EffectSet called_for(const Scene& scene, std::optional<int> bounces = std::nullopt) {
  return analyse_effects(World(scene), bounces).called_for();
}

const EffectSet everything(all_effects().begin(), all_effects().end());

Scene furnace(const Rgb& albedo, const Rgb& emission) {
  SceneBuilder builder;
  builder.room("room", builder.diffuse("wall", albedo, emission), {0, 0, 0}, {1, 1, 1});
  return builder.build("furnace");
}

TEST(SceneEffects, ABoxWithBlocksAndALampCallsForDiffuseLightAndOcclusion) {
  EXPECT_EQ(called_for(box_scene()), (EffectSet{Effect::direct, Effect::diffuse_indirect, Effect::occlusion}));
}

TEST(SceneEffects, WithoutLightNothingIsCalledForAndTheReasonSaysSo) {
  BoxOptions dark;
  dark.lamp_emission = Rgb();
  const SceneEffects effects = analyse_effects(World(box_scene(dark)));
  EXPECT_TRUE(effects.called_for().empty());
  ASSERT_EQ(effects.effects.size(), all_effects().size());
  for (const EffectEvidence& evidence : effects.effects) EXPECT_EQ(evidence.why, "the scene has no light");
}

TEST(SceneEffects, BlackLightsAndEmittersThatNoSurfaceUsesAreNoLight) {
  SceneBuilder builder;
  builder.diffuse("unused lamp", Rgb(0.0F), Rgb(5.0F));
  builder.quad("floor", builder.diffuse("white", Rgb(0.5F)), {Vec3{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}});
  builder.light(PointLight{{0, 1, 0}, Rgb()});
  builder.light(EnvironmentLight{Rgb(), nullptr, 0.0F});
  EXPECT_TRUE(called_for(builder.build("unlit")).empty());
}

TEST(SceneEffects, AnEnvironmentImageOfBlackPixelsIsNoLight) {
  SceneBuilder builder;
  builder.quad("floor", builder.diffuse("white", Rgb(0.5F)), {Vec3{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}});
  auto image = std::make_shared<EnvironmentImage>();
  image->width = 2, image->height = 1, image->pixels = {Rgb(), Rgb()};
  builder.light(EnvironmentLight{Rgb(1.0F), image, 0.0F});
  EXPECT_TRUE(called_for(builder.build("night")).empty());
}

TEST(SceneEffects, BlackWallsCallForNoIndirectLight) {
  const SceneEffects effects = analyse_effects(World(furnace(Rgb(0.0F), Rgb(1.0F))));
  EXPECT_FALSE(effects[Effect::diffuse_indirect].called_for);
  EXPECT_THAT(effects[Effect::diffuse_indirect].why, HasSubstr("albedo"));
  EXPECT_TRUE(effects[Effect::direct].called_for);
}

TEST(SceneEffects, NoBouncesAskedForMeansNoIndirectLight) {
  const SceneEffects none = analyse_effects(World(box_scene()), 0);
  EXPECT_FALSE(none[Effect::diffuse_indirect].called_for);
  EXPECT_THAT(none[Effect::diffuse_indirect].why, HasSubstr("0 bounces"));
  EXPECT_EQ(none.max_bounces, 0);
  EXPECT_TRUE(called_for(box_scene(), 1).contains(Effect::diffuse_indirect));
}

TEST(SceneEffects, AnEnvironmentIsCalledForWhereThereIsOne) {
  EXPECT_FALSE(called_for(box_scene()).contains(Effect::environment));
  BoxOptions options;
  options.lights = {EnvironmentLight{Rgb(1.0F), nullptr, 0.0F}};
  EXPECT_TRUE(called_for(box_scene(options)).contains(Effect::environment));
}

TEST(SceneEffects, GlossyMaterialsInUseCallForGlossyEffects) {
  SceneBuilder builder;
  Material satin;
  satin.name = "satin", satin.bsdf = Bsdf::phong, satin.specular = Rgb(0.4F), satin.exponent = 20.0F;
  builder.room("room", builder.diffuse("wall", Rgb(0.5F), Rgb(1.0F)), {0, 0, 0}, {1, 1, 1});
  const std::uint32_t index = builder.material(satin);
  EXPECT_FALSE(called_for(builder.build("unused satin")).contains(Effect::glossy_final_bounce));
  builder.block("block", index, {0.3F, 0, 0.3F}, {0.6F, 0.3F, 0.6F});
  const EffectSet with_satin = called_for(builder.build("satin"));
  EXPECT_TRUE(with_satin.contains(Effect::glossy_final_bounce));
  EXPECT_TRUE(with_satin.contains(Effect::glossy_chain));
}

TEST(Arrangement, ARoomSeenFromInsideIsConvexUntilSomethingStandsInIt) {
  EXPECT_EQ(arrangement_of(World(furnace(Rgb(0.5F), Rgb(1.0F)))), Arrangement::convex_room);
  EXPECT_EQ(arrangement_of(World(box_scene())), Arrangement::general);
}

TEST(Arrangement, ABlockSeenFromOutsideHasNoMutualSight) {
  SceneBuilder builder;
  builder.block("block", builder.diffuse("white", Rgb(0.5F)), {0, 0, 0}, {1, 2, 1}, 30.0F);
  builder.light(DirectionalLight{{0, -1, 0}, Rgb(1.0F)});
  const World world(builder.build("block"));
  EXPECT_EQ(arrangement_of(world), Arrangement::no_mutual_sight);
  EXPECT_EQ(analyse_effects(world).called_for(), (EffectSet{Effect::direct, Effect::occlusion}));
}

TEST(Arrangement, ATwoSidedPlateOverABlockIsSeenByIt) {
  SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.block("block", white, {0, 0, 0}, {1, 1, 1});
  builder.quad("plate", white, {Vec3{0, 2, 0}, {0, 2, 1}, {1, 2, 1}, {1, 2, 0}}, true);
  EXPECT_EQ(arrangement_of(World(builder.build("plate"))), Arrangement::general);
}

TEST(SceneEffects, OcclusionIsCalledForWhereverThereIsLight) {
  Scene room = furnace(Rgb(0.5F), Rgb());
  EXPECT_FALSE(called_for(room).contains(Effect::occlusion));
  room.lights = {PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)}};
  EXPECT_TRUE(called_for(room).contains(Effect::occlusion));
}

TEST(EffectPlan, SplitsWhatIsCalledForByWhatTheMethodCanDo) {
  const SceneEffects scene = analyse_effects(World(box_scene()), 3);
  const EffectPlan plan = plan_effects(scene, {Effect::diffuse_indirect, Effect::environment});
  EXPECT_EQ(plan.called_for, (EffectSet{Effect::direct, Effect::diffuse_indirect, Effect::occlusion}));
  EXPECT_EQ(plan.simulated, EffectSet{Effect::diffuse_indirect});
  EXPECT_EQ(plan.missing, (EffectSet{Effect::direct, Effect::occlusion}));
  EXPECT_EQ(plan.max_bounces, 3);
  EffectSet skipped;
  for (const SkippedEffect& effect : plan.skipped) {
    skipped.insert(effect.effect);
    EXPECT_FALSE(effect.why.empty());
  }
  EXPECT_EQ(skipped, (EffectSet{Effect::glossy_final_bounce, Effect::glossy_chain, Effect::environment}));
}

TEST(EffectPlan, AMethodThatCanDoEverythingMissesNothing) {
  const EffectPlan plan = plan_effects(analyse_effects(World(box_scene())), everything);
  EXPECT_TRUE(plan.missing.empty());
  EXPECT_EQ(plan.simulated, plan.called_for);
}

TEST(Effect, EveryEffectHasANameAndAMeaning) {
  std::set<std::string> names;
  for (const Effect effect : all_effects()) {
    names.insert(to_string(effect));
    EXPECT_STRNE(meaning_of(effect), "unknown");
  }
  EXPECT_EQ(names.size(), all_effects().size());
  EXPECT_FALSE(names.contains("unknown"));
}

}  // namespace
}  // namespace gibench
