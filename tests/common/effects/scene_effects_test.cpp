#include "common/effects/scene_effects.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "common/core/error.h"
#include "common/effects/plan_paths.h"
#include "common/effects/sealed.h"
#include "common/light_paths/automaton.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

using made::box_scene;
using made::BoxOptions;
using made::SceneBuilder;
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
  EXPECT_EQ(called_for(box_scene()), (EffectSet{Effect::direct, Effect::diffuse_indirect, Effect::occlusion, Effect::colour}));
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
  EXPECT_EQ(analyse_effects(world).called_for(), EffectSet{Effect::direct});
}

TEST(Arrangement, ATwoSidedPlateOverABlockIsSeenByIt) {
  SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.block("block", white, {0, 0, 0}, {1, 1, 1});
  builder.quad("plate", white, {Vec3{0, 2, 0}, {0, 2, 1}, {1, 2, 1}, {1, 2, 0}}, true);
  EXPECT_EQ(arrangement_of(World(builder.build("plate"))), Arrangement::general);
}

TEST(SceneEffects, AConvexRoomHidesNoLightThatIsInsideIt) {
  Scene room = furnace(Rgb(0.5F), Rgb(1.0F));
  EXPECT_FALSE(called_for(room).contains(Effect::occlusion)) << "its walls";
  room.lights = {PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)}, SpotLight{{0.5F, 1.0F, 0.5F}, {0, -1, 0}, Rgb(1.0F), 0.9F, 0.8F}};
  EXPECT_FALSE(called_for(room).contains(Effect::occlusion)) << "inside, and in the ceiling";
  room.lights = {PointLight{{0.5F, 1.5F, 0.5F}, Rgb(1.0F)}};
  EXPECT_TRUE(called_for(room).contains(Effect::occlusion)) << "above the ceiling";
}

TEST(SceneEffects, AClosedRoomIsNotLitByWhatLiesOutside) {
  Scene room = furnace(Rgb(0.5F), Rgb(1.0F));
  room.lights = {EnvironmentLight{Rgb(1.0F), nullptr, 0.0F}, DirectionalLight{{0, -1, 0}, Rgb(1.0F)}};
  const SceneEffects effects = analyse_effects(World(room));
  EXPECT_TRUE(effects.sealed);
  EXPECT_FALSE(effects[Effect::environment].called_for);
  EXPECT_THAT(effects[Effect::environment].why, HasSubstr("closed"));
  EXPECT_FALSE(effects[Effect::occlusion].called_for);
  EXPECT_FALSE(effects.events.contains(PathEvent::background));
  for (Material& material : room.materials) material.emission = Rgb();
  const SceneEffects unlit = analyse_effects(World(room));
  EXPECT_TRUE(unlit.unlit && unlit.called_for().empty());
  EXPECT_THAT(unlit[Effect::direct].why, HasSubstr("closed"));
}

/// The floor plan of an L, walls 1 m high, fronts inwards; the corners run against the clock seen from above.
Scene l_room(bool with_ceiling = true) {
  SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  const std::vector<Vec2> plan{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<Vec3> vertices;
  for (const float y : {0.0F, 1.0F})
    for (const Vec2& p : plan) vertices.emplace_back(p.x, y, -p.y);
  std::vector<std::array<std::uint32_t, 4>> faces;
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    faces.push_back({i, i + 6, j + 6, j});
  }
  faces.push_back({0, 1, 2, 3});
  faces.push_back({0, 3, 4, 5});
  if (with_ceiling) faces.push_back({9, 8, 7, 6}), faces.push_back({11, 10, 9, 6});
  builder.object("room", white, vertices, faces);
  builder.light(EnvironmentLight{Rgb(1.0F), nullptr, 0.0F});
  return builder.build("L");
}

TEST(Sealed, ANonConvexClosedRoomIsSealedUntilItLosesItsCeiling) {
  EXPECT_TRUE(is_sealed(World(l_room())));
  EXPECT_FALSE(is_sealed(World(l_room(false))));
  EXPECT_TRUE(called_for(l_room(false)).contains(Effect::environment));
}

TEST(Sealed, WhatStandsInARoomIsInsideAndWhatReachesOutIsNot) {
  const auto with_block = [](const Vec3& low, const Vec3& high, bool two_sided_room = false) {
    SceneBuilder builder;
    const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
    builder.room("room", white, {0, 0, 0}, {1, 1, 1});
    builder.block("block", white, low, high);
    builder.light(EnvironmentLight{Rgb(1.0F), nullptr, 0.0F});
    Scene scene = builder.build("room");
    scene.objects.front().two_sided = two_sided_room;
    return is_sealed(World(scene));
  };
  EXPECT_TRUE(with_block({0.2F, 0.2F, 0.2F}, {0.5F, 0.5F, 0.5F}));
  EXPECT_FALSE(with_block({0.2F, 0.0F, 0.2F}, {0.5F, 0.5F, 0.5F})) << "its bottom looks through the floor it stands on";
  EXPECT_FALSE(with_block({0.2F, 0.2F, 0.2F}, {0.5F, 1.5F, 0.5F}));
  EXPECT_FALSE(with_block({2.0F, 0.0F, 0.0F}, {3.0F, 1.0F, 1.0F}));
  EXPECT_FALSE(with_block({0.2F, 0.2F, 0.2F}, {0.5F, 0.5F, 0.5F}, true)) << "the walls' other sides are lit";
}

TEST(SceneEffects, GreyScenesDoNotCallForColour) {
  Scene room = furnace(Rgb(0.5F), Rgb(1.0F));
  const SceneEffects grey = analyse_effects(World(room));
  EXPECT_FALSE(grey[Effect::colour].called_for);
  EXPECT_TRUE(grey.grey_surfaces);
  room.lights = {PointLight{{0.5F, 0.5F, 0.5F}, {1.0F, 0.9F, 0.8F}}};
  EXPECT_TRUE(called_for(room).contains(Effect::colour));
  EXPECT_TRUE(analyse_effects(World(room)).grey_surfaces);
  EXPECT_TRUE(called_for(furnace({0.5F, 0.6F, 0.5F}, Rgb(1.0F))).contains(Effect::colour));
}

TEST(SceneEffects, TwoSidedObjectsAreTold) {
  SceneBuilder builder;
  builder.quad("plate", builder.diffuse("white", Rgb(0.5F)), {Vec3{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}, true);
  builder.light(PointLight{{0, 1, 0}, Rgb(1.0F)});
  const SceneEffects effects = analyse_effects(World(builder.build("plate")));
  EXPECT_TRUE(effects[Effect::two_sided].called_for);
  EXPECT_THAT(effects[Effect::two_sided].why, HasSubstr("plate"));
  EXPECT_FALSE(called_for(box_scene()).contains(Effect::two_sided));
}

TEST(SceneEffects, LightsAreToldByKind) {
  BoxOptions options;
  options.lights = {PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)}, PointLight{{0.5F, 0.5F, 0.5F}, Rgb()},
                    SpotLight{{0.5F, 0.9F, 0.5F}, {0, -1, 0}, Rgb(1.0F), 0.9F, 0.8F}};
  const SceneEffects effects = analyse_effects(World(box_scene(options)));
  EXPECT_EQ(effects.lights, (LightCounts{1, {1, 1, 0, 0}}));
  EXPECT_THAT(effects[Effect::direct].why, HasSubstr("1 point light, 1 spot light"));
}

TEST(BounceBound, IsTheLeastThatTheLargestAlbedoProves) {
  for (const float albedo : {0.2F, 0.5F, 0.9F})
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
      const BounceBound bound = bounce_bound(reflectances_of(World(furnace(Rgb(albedo), Rgb(1.0F)))), tolerance);
      ASSERT_TRUE(bound.most);
      EXPECT_LE(std::pow(double{albedo}, *bound.most + 1), tolerance);
      EXPECT_GT(std::pow(double{albedo}, *bound.most), tolerance);
    }
}

TEST(BounceBound, WhatCannotBeBoundedSaysSo) {
  const BounceBound bound = bounce_bound(reflectances_of(World(furnace(Rgb(0.9999F), Rgb(1.0F)))), 1e-3);
  EXPECT_FALSE(bound.most);
  EXPECT_THAT(bound.why, HasSubstr("not bounded"));
  EXPECT_EQ(bounce_bound(reflectances_of(World(furnace(Rgb(), Rgb(1.0F)))), 1e-3).most, 0);
  SceneBuilder builder;
  Material metal;
  metal.name = "metal", metal.bsdf = Bsdf::ggx, metal.roughness = 0.3F, metal.f0 = Rgb(0.04F);
  builder.room("room", builder.material(metal), {0, 0, 0}, {1, 1, 1});
  EXPECT_FALSE(bounce_bound(reflectances_of(World(builder.build("metal"))), 1e-3).most) << "everything at grazing angles";
}

TEST(BounceBound, BindsOnlyWithAToleranceAndTogetherWithTheUsersBound) {
  const World world(furnace(Rgb(0.5F), Rgb(1.0F)));
  EXPECT_EQ(analyse_effects(world).max_bounces, std::nullopt);
  EXPECT_EQ(analyse_effects(world, {.allowed = {}, .bounces = {}, .tolerance = 0.1, .forced = {}}).max_bounces, 3);
  EXPECT_EQ(analyse_effects(world, {.allowed = {}, .bounces = 2, .tolerance = 0.1, .forced = {}}).max_bounces, 2);
  EXPECT_EQ(analyse_effects(world, {.allowed = {}, .bounces = 9, .tolerance = 0.1, .forced = {}}).max_bounces, 3);
}

TEST(Changes, AreToldByTheirKind) {
  Scene scene = box_scene();
  EXPECT_EQ(names_of(changes_of(scene)), "none");
  Material white = scene.materials.front();
  white.diffuse = Rgb(0.3F);
  scene.edits = {MaterialEdit{white.name, white}};
  EXPECT_EQ(names_of(changes_of(scene)), "albedo only");
  scene.edits.push_back(MaterialEdit{white.name, white});
  EXPECT_EQ(names_of(changes_of(scene)), "albedo only") << "the second changes nothing";
  scene.edits = {LightEdit{0, PointLight{}}};
  EXPECT_EQ(names_of(changes_of(scene)), "lights only");
  white = scene.materials.front();
  white.emission = Rgb(2.0F);
  scene.edits.push_back(MaterialEdit{white.name, white});
  EXPECT_EQ(names_of(changes_of(scene)), "lights only") << "what a surface emits is light";
  scene.edits = {MoveEdit{"tall", Vec3d(0.1), Vec3d(0.0)}};
  EXPECT_EQ(names_of(changes_of(scene)), "motion only");
  scene.edits.push_back(DeformEdit{"tall", "tall.ply"});
  EXPECT_EQ(changes_of(scene), (std::set<Change>{Change::motion, Change::deformation}));
}

TEST(EffectPlan, SplitsWhatIsCalledForByWhatTheMethodCanDo) {
  const SceneEffects scene = analyse_effects(World(box_scene()), 3);
  const EffectPlan plan = plan_effects(scene, {Effect::diffuse_indirect, Effect::environment});
  EXPECT_EQ(plan.called_for, (EffectSet{Effect::direct, Effect::diffuse_indirect, Effect::occlusion, Effect::colour}));
  EXPECT_EQ(plan.simulated, (EffectSet{Effect::diffuse_indirect, Effect::colour}));
  EXPECT_EQ(plan.missing, (EffectSet{Effect::direct, Effect::occlusion}));
  EXPECT_EQ(plan.max_bounces, 3);
  EffectSet skipped;
  for (const SkippedEffect& effect : plan.skipped) {
    skipped.insert(effect.effect);
    EXPECT_FALSE(effect.why.empty());
  }
  EXPECT_EQ(skipped, (EffectSet{Effect::glossy_final_bounce, Effect::glossy_chain, Effect::environment, Effect::two_sided}));
}

TEST(EffectPlan, AMethodThatCanDoEverythingMissesNothing) {
  const EffectPlan plan = plan_effects(analyse_effects(World(box_scene())), everything);
  EXPECT_TRUE(plan.missing.empty());
  EXPECT_EQ(plan.simulated, plan.called_for);
}

TEST(EffectPlan, WhatTheUserDoesNotAllowIsSkippedAndNotMissing) {
  const World world(box_scene());
  const PlanLimits limits{EffectSet{Effect::direct}, {}, 0.0, {}};
  const EffectPlan plan = plan_effects(analyse_effects(world, limits), everything);
  EXPECT_EQ(plan.simulated, (EffectSet{Effect::direct, Effect::occlusion, Effect::colour}))
      << "a choice of paths does not choose shadows";
  EXPECT_TRUE(plan.missing.empty());
  EXPECT_TRUE(plan.forbids(Effect::diffuse_indirect));
  EXPECT_TRUE(plan.skips_indirect());
  EXPECT_EQ(light_paths_of(plan), "C.{0,1}[LOB]");
  const EffectPlan nothing = plan_effects(analyse_effects(world, {EffectSet{}, {}, 0.0, {}}), everything);
  EXPECT_EQ(light_paths_of(nothing), "C[^.]");
}

TEST(EffectPlan, SaysWhichLightPathsItMeans) {
  EffectPlan plan;
  EXPECT_EQ(light_paths_of(plan), "C.*[LOB]");
  plan.max_bounces = 3;
  EXPECT_EQ(light_paths_of(plan), "C.{0,4}[LOB]");
  EXPECT_EQ(light_paths_of(plan, false, {2, 2}), "C..{2,2}[LOB]");
  EXPECT_EQ(light_paths_of(plan, false, {0, 0}), "C.{0,1}[LOB]");
  EXPECT_EQ(light_paths_of(plan, false, {4, 4}), "C[^.]") << "beyond the bound";
  plan.max_bounces.reset();
  plan.called_for = {Effect::direct, Effect::diffuse_indirect, Effect::glossy_final_bounce, Effect::glossy_chain,
                     Effect::environment};
  plan.simulated = {Effect::direct, Effect::diffuse_indirect, Effect::environment};
  plan.missing = {Effect::glossy_final_bounce, Effect::glossy_chain};
  EXPECT_EQ(light_paths_of(plan), "CD{0,1}[LOB]|CDD+[LOB]");
  EXPECT_EQ(light_paths_of(plan, true), "C.{0,1}[LOB]|CDD+[LOB]");
  plan.simulated = {Effect::direct, Effect::glossy_final_bounce, Effect::glossy_chain};
  EXPECT_EQ(light_paths_of(plan), "C.{0,1}[LO]|C.D*[GS].*[LO]");
}

TEST(EffectPlan, MeansChainsOfAHundredBouncesToo) {
  EffectPlan plan;
  plan.called_for = {Effect::direct, Effect::diffuse_indirect, Effect::glossy_chain};
  plan.simulated = {Effect::glossy_chain};
  plan.max_bounces = 150;
  /// Seen, then so many scatterings, the last of them of this kind.
  const auto chain = [](std::size_t scatterings, PathEvent last) {
    std::vector<PathEvent> path(scatterings + 3, PathEvent::diffuse_reflection);
    path.front() = PathEvent::camera, path[scatterings + 1] = last, path.back() = PathEvent::emitter;
    return path;
  };
  const PathAutomaton all(light_paths_of(plan)), last(light_paths_of(plan, false, {150, 150})),
      later(light_paths_of(plan, false, {120, {}}));
  EXPECT_TRUE(all.matches(chain(150, PathEvent::glossy_reflection)));
  EXPECT_FALSE(all.matches(chain(150, PathEvent::diffuse_reflection)));
  EXPECT_FALSE(all.matches(chain(151, PathEvent::glossy_reflection)));
  EXPECT_TRUE(last.matches(chain(150, PathEvent::mirror_reflection)));
  EXPECT_FALSE(last.matches(chain(149, PathEvent::mirror_reflection)));
  EXPECT_TRUE(later.matches(chain(120, PathEvent::glossy_reflection)));
  EXPECT_FALSE(later.matches(chain(119, PathEvent::glossy_reflection)));
}

/// Every choice of effects: the paths of its plan are those of its classes, one by one.
TEST(EffectPlan, ClassesOfEffectsPartThePaths) {
  const EffectSet classes{Effect::direct, Effect::diffuse_indirect, Effect::glossy_chain};
  const std::vector<PathEvent> kinds{PathEvent::diffuse_reflection, PathEvent::glossy_reflection, PathEvent::mirror_reflection};
  std::vector<std::pair<Effect, PathAutomaton>> single;
  for (const std::optional<int> bound : {std::optional<int>(), std::optional<int>(3)}) {
    single.clear();
    for (const Effect effect : classes) {
      EffectPlan plan;
      plan.called_for = classes, plan.simulated = {effect}, plan.max_bounces = bound;
      single.emplace_back(effect, PathAutomaton(light_paths_of(plan)));
    }
    EffectPlan whole;
    whole.max_bounces = bound;
    const PathAutomaton all(light_paths_of(whole));
    for (int path = 0; path < 3 * 3 * 3 * 3 * 3 * 6; ++path) {
      std::vector<PathEvent> events{PathEvent::camera};
      for (int i = 0, rest = path; i < path % 6; ++i, rest /= 3) events.push_back(kinds[static_cast<std::size_t>(rest % 3)]);
      events.push_back(PathEvent::emitter);
      int in = 0;
      for (const auto& one : single) in += one.second.matches(events) ? 1 : 0;
      EXPECT_EQ(in, all.matches(events) ? 1 : 0);
    }
  }
}

TEST(EffectPlan, UnknownNamesAreRefusedWithTheKnownOnes) {
  try {
    effects_of_names({"direct", "magic"}, "--effects");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("--effects"), HasSubstr("'magic'"), HasSubstr("glossy_chain")));
  }
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
