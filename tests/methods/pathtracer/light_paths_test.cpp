/// The path tracer restricted to classes of light paths.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <utility>

#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/pathtracer/pathtracer.h"

namespace gibench {
namespace {

using made::SceneBuilder;

struct Restricted {
  std::vector<Rgb> total, variance;
  Counters counters;

  std::uint64_t rays() const { return counters["closest_hit_rays"] + counters["occlusion_rays"]; }
};

struct Asked {
  std::string light_paths;
  int samples = 256;
  std::uint64_t seed = 3;
  int threads = 2;
  EffectSet forced = {};
};

/// Radiance along the normal, or irradiance, at points strewn over the scene.
Restricted ask(const Scene& scene, Quantity quantity, const Asked& asked) {
  const World world(scene, 1);
  const MethodEntry entry = pathtracer_entry();
  const auto method = make_session(entry, Parameters(entry.schema, {{"samples", std::to_string(asked.samples)}}));
  EffectPlan plan =
      plan_effects(analyse_effects(world, PlanLimits{{}, {}, 0.0, asked.forced}), effects_of(method->capabilities()));
  plan.light_paths = asked.light_paths;
  TaskSettings settings;
  settings.seed = asked.seed, settings.threads = asked.threads;
  Task task(settings);
  EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
  EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
  const auto samples = area_uniform_samples(world, 60, 5);
  std::vector<Vec3> viewers;
  if (quantity == Quantity::radiance)
    for (const SurfaceSample& sample : samples) viewers.push_back(sample.normal);
  Restricted result;
  std::vector<Rgb> direct(samples.size()), indirect(samples.size());
  result.variance.resize(samples.size());
  EXPECT_TRUE(
      succeeded(method->shade({quantity, samples, viewers}, {direct, indirect, {}, {}, result.variance}, task).termination));
  for (std::size_t i = 0; i < samples.size(); ++i) result.total.push_back(direct[i] + indirect[i]);
  result.counters = task.counters();
  return result;
}

struct Mean {
  double value = 0.0, variance = 0.0;
};

Mean mean_of(const Restricted& answer) {
  Mean mean;
  const double count = 3.0 * static_cast<double>(answer.total.size());
  for (std::size_t i = 0; i < answer.total.size(); ++i)
    for (int c = 0; c < 3; ++c) {
      mean.value += double{answer.total[i][c]} / count;
      mean.variance += double{answer.variance[i][c]} / (count * count) * 3.0;  // the channels of a path are one sample
    }
  return mean;
}

/// The classes, each by its own random numbers, add up to the whole within four standard errors.
void expect_sum(const Scene& scene, Quantity quantity, const std::vector<std::string>& classes, const std::string& whole,
                int samples) {
  Mean sum;
  std::uint64_t seed = 100;
  for (const std::string& paths : classes) {
    const Mean part = mean_of(ask(scene, quantity, {paths, samples, ++seed}));
    sum.value += part.value, sum.variance += part.variance;
  }
  const Mean all = mean_of(ask(scene, quantity, {whole, samples, 99}));
  EXPECT_GT(all.value, 0.0);
  EXPECT_NEAR(sum.value, all.value, 4.0 * std::sqrt(sum.variance + all.variance)) << whole;
}

/// A room with a mirror beside a lamp, and blocks of Phong and GGX.
Scene glossy_room() {
  SceneBuilder builder;
  Material mirror, satin, metal;
  mirror.name = "mirror", mirror.bsdf = Bsdf::mirror, mirror.reflectance = Rgb(0.9F);
  satin.name = "satin", satin.bsdf = Bsdf::phong, satin.diffuse = Rgb(0.3F, 0.4F, 0.2F), satin.specular = Rgb(0.4F),
  satin.exponent = 15.0F;
  metal.name = "metal", metal.bsdf = Bsdf::ggx, metal.roughness = 0.5F, metal.f0 = {0.8F, 0.6F, 0.3F}, metal.diffuse = Rgb(0.1F);
  const std::uint32_t white = builder.diffuse("white", Rgb(0.6F)), lamp = builder.diffuse("lamp", Rgb(), Rgb(20.0F));
  builder.room("room", white, {0, 0, 0}, {1, 1, 1});
  builder.quad("lamp", lamp, {Vec3{0.4F, 0.99F, 0.4F}, {0.6F, 0.99F, 0.4F}, {0.6F, 0.99F, 0.6F}, {0.4F, 0.99F, 0.6F}});
  builder.block("mirror", builder.material(mirror), {0.05F, 0.1F, 0.2F}, {0.1F, 0.7F, 0.8F});
  builder.block("satin", builder.material(satin), {0.5F, 0, 0.2F}, {0.8F, 0.3F, 0.5F});
  builder.block("metal", builder.material(metal), {0.5F, 0, 0.6F}, {0.8F, 0.4F, 0.8F});
  builder.light(PointLight{{0.3F, 0.8F, 0.7F}, {0.5F, 0.4F, 0.3F}});
  return builder.build("glossy room");
}

TEST(LightPaths, BouncesOfADiffuseSceneAddUpToTheWhole) {
  const Scene box = made::box_scene();
  std::vector<std::string> bounces{"C.{0,1}[LOB]"};
  for (int k = 1; k <= 12; ++k) bounces.push_back("C.{" + std::to_string(k + 1) + "}[LOB]");
  for (const Quantity quantity : {Quantity::irradiance, Quantity::radiance})
    expect_sum(box, quantity, bounces, "C.{0,13}[LOB]", 1024);
}

TEST(LightPaths, DirectAndIndirectLightAddUpToAll) {
  for (const Scene& scene : {made::box_scene(), glossy_room()})
    for (const Quantity quantity : {Quantity::irradiance, Quantity::radiance})
      expect_sum(scene, quantity, {"C.{0,1}[LOB]", "C.{2,}[LOB]"}, "", 1024);
}

TEST(LightPaths, LobesOfTheSeenSurfaceAddUpToItsWhole) {
  expect_sum(glossy_room(), Quantity::radiance, {"C[LOB]", "CD.*[LOB]", "CG.*[LOB]", "CS.*[LOB]"}, "C.*[LOB]", 2048);
}

TEST(LightPaths, LobesAlongTheWayAddUpToo) {
  expect_sum(glossy_room(), Quantity::radiance,
             {"C.{0,1}[LOB]", "C.D[LOB]", "C.G[LOB]", "C.S[LOB]", "C..D.*[LOB]", "C..[GS].*[LOB]"}, "C.*[LOB]", 2048);
  expect_sum(glossy_room(), Quantity::irradiance, {"CD*[LOB]", "CD*[GS].*[LOB]"}, "C.*[LOB]", 2048);
}

TEST(LightPaths, LightsAddUpByTheirKind) {
  expect_sum(glossy_room(), Quantity::irradiance, {"C.*L", "C.*O", "C.*B"}, "C.*[LOB]", 1024);
}

TEST(LightPaths, TheWholeIsTheSameBitsAsNoRestriction) {
  for (const Scene& scene : {made::box_scene(), glossy_room()}) {
    const Restricted free = ask(scene, Quantity::radiance, {""}), whole = ask(scene, Quantity::radiance, {"C.*[LOB]"});
    EXPECT_EQ(free.total, whole.total);
    EXPECT_EQ(free.rays(), whole.rays());
  }
}

TEST(LightPaths, ARestrictedAnswerDoesNotDependOnTheThreads) {
  Asked one{"CD.*[GS]+D*[LOB]"}, two = one;
  one.threads = 1, two.threads = 2;
  EXPECT_EQ(ask(glossy_room(), Quantity::radiance, one).total, ask(glossy_room(), Quantity::radiance, two).total);
}

TEST(LightPaths, ARestrictedAnswerCostsLess) {
  const Scene scene = glossy_room();
  const std::uint64_t whole = ask(scene, Quantity::irradiance, {"C.*[LOB]"}).rays();
  const std::uint64_t diffuse = ask(scene, Quantity::irradiance, {"CD*[LOB]"}).rays();
  const std::uint64_t two = ask(scene, Quantity::irradiance, {"C.{0,2}[LOB]"}).rays();
  const std::uint64_t direct = ask(scene, Quantity::irradiance, {"C.{0,1}[LOB]"}).rays();
  EXPECT_LT(diffuse, whole);
  EXPECT_LT(two, whole / 2);
  EXPECT_LT(direct, two);
  EXPECT_EQ(ask(scene, Quantity::irradiance, {"C.*B"}).rays(), 0U) << "there is no environment";
  EXPECT_EQ(ask(made::box_scene(), Quantity::irradiance, {"CD*[GS].*[LOB]"}).rays(), 0U) << "nothing is glossy";
}

/// A mirror throws the light of a lamp that faces it onto the floor under a screen.
TEST(LightPaths, ACausticIsInTheWholeAndNotInTheDiffusePaths) {
  SceneBuilder builder;
  Material mirror;
  mirror.name = "mirror", mirror.bsdf = Bsdf::mirror, mirror.reflectance = Rgb(0.9F);
  const std::uint32_t floor = builder.diffuse("floor", Rgb(0.5F)), black = builder.diffuse("black", Rgb());
  builder.quad("floor", floor, {Vec3{-1, 0, -1}, {-1, 0, 1}, {1, 0, 1}, {1, 0, -1}});
  builder.quad("mirror", builder.material(mirror), {Vec3{-1, 0, -1}, {1, 0, -1}, {1, 2, -1}, {-1, 2, -1}});
  builder.block("screen", black, {-0.6F, 0.5F, -0.2F}, {0.6F, 0.55F, 0.9F});
  builder.quad("lamp", builder.diffuse("lamp", Rgb(), Rgb(10.0F)),
               {Vec3{-0.2F, 0.8F, 0.6F}, {-0.2F, 1.2F, 0.6F}, {0.2F, 1.2F, 0.6F}, {0.2F, 0.8F, 0.6F}});
  const World world(builder.build("caustic"), 1);
  const auto lit = [&](const std::string& paths) {
    const MethodEntry entry = pathtracer_entry();
    const auto method = make_session(entry, Parameters(entry.schema, {{"samples", "262144"}}));
    EffectPlan plan = plan_effects(analyse_effects(world), effects_of(method->capabilities()));
    plan.light_paths = paths;
    Task task;
    EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
    EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
    const Hit hit = world.rays().closest_hit({{0.0F, 0.3F, 0.0F}, 0.0F, {0, -1, 0}});
    const std::vector<SurfaceSample> samples{world.sample_of_hit(hit, {0, -1, 0})};
    std::vector<Rgb> direct(1), indirect(1);
    EXPECT_TRUE(succeeded(method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task).termination));
    return (direct[0] + indirect[0]).g;
  };
  EXPECT_EQ(lit("CD*[LOB]"), 0.0F) << "the screen hides the lamp, and nothing diffuse is in sight but the floor";
  // 0.16 m² of 10 W/(m² sr), seen by nine tenths in the mirror, 1 m up and 2.6 m away: the centre stands for the lamp.
  const float squared = 1.0F + 2.6F * 2.6F;
  const float caustic = 0.9F * 10.0F * 0.16F * 2.6F / (squared * squared);
  const float mirrored = lit("CDS[LOB]");
  EXPECT_NEAR(mirrored, caustic, 0.2F * caustic) << "some 570 paths find the lamp, which is not small";
  EXPECT_GT(lit("C.*[LOB]"), 0.9F * mirrored);
}

TEST(Planned, AConvexRoomIsTheSameWithAndWithoutVisibilityRays) {
  SceneBuilder builder;
  builder.room("room", builder.diffuse("wall", {0.5F, 0.4F, 0.3F}, Rgb(0.2F)), {0, 0, 0}, {1, 1, 1});
  builder.light(PointLight{{0.5F, 0.7F, 0.5F}, Rgb(1.0F)});
  const Scene room = builder.build("room");
  Asked forced{""};
  forced.forced = {Effect::occlusion};
  const Restricted without = ask(room, Quantity::irradiance, {""}), with = ask(room, Quantity::irradiance, forced);
  EXPECT_EQ(without.counters["occlusion_rays"], 0U);
  EXPECT_GT(with.counters["occlusion_rays"], 0U);
  const double scale = mean_of(with).value;
  for (std::size_t i = 0; i < with.total.size(); ++i)
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(without.total[i][c], with.total[i][c], 1e-3 * scale);
}

TEST(Planned, ABlackRoomTracesDirectLightAlone) {
  made::BoxOptions options;
  options.floor_albedo = options.left_albedo = options.right_albedo = Rgb();
  const Scene black = made::box_scene(options);
  EXPECT_EQ(ask(black, Quantity::irradiance, {""}).rays(), ask(black, Quantity::irradiance, {"C.{0,1}[LOB]"}).rays());
}

/// A room of one albedo, its ceiling a black lamp.
Scene lamp_room(float albedo) {
  SceneBuilder builder;
  const std::uint32_t wall = builder.diffuse("wall", Rgb(albedo)), lamp = builder.diffuse("lamp", Rgb(), Rgb(1.0F));
  builder.room("room", wall, {0, 0, 0}, {1, 1, 1});
  builder.quad("lamp", lamp, {Vec3{0.3F, 0.99F, 0.3F}, {0.7F, 0.99F, 0.3F}, {0.7F, 0.99F, 0.7F}, {0.3F, 0.99F, 0.7F}});
  return builder.build("lamp room");
}

/// The same paths with and without the bound: their difference is the light that the bound leaves out.
TEST(Planned, TheBounceBoundLeavesOutLessThanItsTolerance) {
  for (const float albedo : {0.2F, 0.5F, 0.9F}) {
    const World world(lamp_room(albedo), 1);
    const auto samples = area_uniform_samples(world, 100, 5);
    const auto irradiance = [&](double tolerance) {
      const MethodEntry entry = pathtracer_entry();
      const auto method = make_session(entry, Parameters(entry.schema, {{"samples", "1024"}}));
      const EffectPlan plan =
          plan_effects(analyse_effects(world, PlanLimits{{}, {}, tolerance, {}}), effects_of(method->capabilities()));
      Task task;
      EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
      EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
      std::vector<Rgb> direct(samples.size()), indirect(samples.size());
      EXPECT_TRUE(
          succeeded(method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task).termination));
      double sum = 0.0, rays = static_cast<double>(task.counters()["closest_hit_rays"]);
      for (std::size_t i = 0; i < samples.size(); ++i) sum += double{direct[i].g} + double{indirect[i].g};
      return std::pair(sum, rays);
    };
    const auto [all, all_rays] = irradiance(0.0);
    double rays_before = 0.0;
    for (const double tolerance : {1e-1, 1e-2, 1e-3}) {
      const auto [bounded, rays] = irradiance(tolerance);
      EXPECT_GE(all - bounded, 0.0) << albedo << ' ' << tolerance;
      EXPECT_LT(all - bounded, tolerance * all) << albedo << ' ' << tolerance;
      EXPECT_LT(rays, all_rays) << albedo << ' ' << tolerance;
      EXPECT_GT(rays, rays_before) << albedo << ' ' << tolerance;
      rays_before = rays;
    }
  }
}

/// Where nothing is glossy, leaving out glossy paths changes neither the answer nor the work nor the memory.
TEST(Planned, ADiffuseSceneCostsNothingForGlossySupport) {
  const World world(made::box_scene(), 1);
  const auto samples = area_uniform_samples(world, 60, 5);
  const auto run = [&](const std::optional<EffectSet>& allowed) {
    const MethodEntry entry = pathtracer_entry();
    const auto method = make_session(entry, Parameters(entry.schema, {}));
    const EffectPlan plan =
        plan_effects(analyse_effects(world, PlanLimits{allowed, {}, 0.0, {}}), effects_of(method->capabilities()));
    Task task;
    EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
    EXPECT_TRUE(succeeded(method->light(Lighting::of(world.scene()), task).termination));
    std::vector<Rgb> direct(samples.size()), indirect(samples.size());
    EXPECT_TRUE(succeeded(method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task).termination));
    return std::tuple(indirect, task.counters()["closest_hit_rays"], task.counters()["occlusion_rays"], method->bytes());
  };
  EXPECT_EQ(run(std::nullopt), run(EffectSet{Effect::direct, Effect::diffuse_indirect}));
}

}  // namespace
}  // namespace gibench
