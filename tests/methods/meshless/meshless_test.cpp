/// The whole method, against closed forms and converged solutions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "common/scene/tessellate.h"
#include "tests/methods/meshless/basis_scene.h"
#include "tests/methods/meshless/solved.h"

namespace gibench::test {
namespace {

void expect_within(const std::vector<Rgb>& values, const Rgb& expected, float share) {
  for (const Rgb& value : values)
    for (int channel = 0; channel < 3; ++channel) EXPECT_NEAR(value[channel], expected[channel], share * expected[channel]);
}

TEST(Meshless, EveryBounceOfAFurnaceIsAGeometricTerm) {
  const Rgb albedo(0.3F, 0.5F, 0.8F);
  Rgb term(pi), sum;
  for (int bounces = 1; bounces <= 3; ++bounces) {
    // Sixteen light samples at a hit: one, where everything glows, leaves 1.3% of noise in a gather.
    Solved solved(furnace(albedo), bounces, {{"levels", "3"}, {"direct_samples", "16"}});
    sum += term *= albedo;
    expect_within(solved.irradiance(area_uniform_samples(solved.world(), 200, 3)), sum, 0.01F);
    EXPECT_EQ(solved.lit.counters["bounces"], static_cast<std::uint64_t>(bounces));
    EXPECT_EQ(solved.lit.termination, Termination::bound_reached);
  }
}

TEST(Meshless, AFurnaceComesToItsLimitEvenWithBrightWalls) {
  const Rgb albedo(0.5F, 0.9F, 0.99F);
  Solved solved(furnace(albedo), std::nullopt, {{"levels", "3"}, {"direct_samples", "16"}});
  EXPECT_EQ(solved.lit.termination, Termination::converged) << solved.lit.message;
  EXPECT_LT(solved.lit.counters["bounces"], 30U);
  Rgb limit;
  for (int channel = 0; channel < 3; ++channel) limit[channel] = pi * albedo[channel] / (1.0F - albedo[channel]);
  expect_within(solved.irradiance(area_uniform_samples(solved.world(), 200, 3)), limit, 0.01F);
}

TEST(Meshless, WithoutExtrapolationTheResidualFallsToItsBound) {
  Solved solved(furnace(Rgb(0.5F)), std::nullopt,
                {{"extrapolate", "false"}, {"residual", "0.0001"}, {"levels", "3"}, {"direct_samples", "16"}});
  EXPECT_EQ(solved.lit.termination, Termination::converged);
  std::vector<double> residuals;
  for (const ProgressPoint& point : solved.lit.history)
    if (point.residual >= 0.0) residuals.push_back(point.residual);
  ASSERT_GT(residuals.size(), 5U);
  EXPECT_TRUE(std::is_sorted(residuals.rbegin(), residuals.rend()));
  EXPECT_LT(residuals.back(), 1e-4);
  expect_within(solved.irradiance(area_uniform_samples(solved.world(), 50, 3)), Rgb(pi), 0.01F);
}

TEST(Meshless, ASceneThatAbsorbsNothingIsNotConverged) {
  Solved solved(furnace(Rgb(1.0F)), std::nullopt, {{"bounces", "8"}, {"levels", "2"}});
  EXPECT_EQ(solved.lit.termination, Termination::not_converged);
  EXPECT_NE(solved.lit.message.find("absorbs no light"), std::string::npos);
}

/// A unit cube whose ceiling-less top face glows: converged radiosity solutions to 1e-6 (two discretisations agree).
Scene glowing_floor_cube(float albedo) {
  made::SceneBuilder builder;
  const std::uint32_t wall = builder.diffuse("wall", Rgb(albedo)), lamp = builder.diffuse("lamp", Rgb(albedo), Rgb(1.0F));
  builder.quad("lamp", lamp, {{{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}}});
  builder.quad("floor", wall, {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}});
  builder.quad("x0", wall, {{{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}}});
  builder.quad("x1", wall, {{{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}}});
  builder.quad("y0", wall, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("y1", wall, {{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}});
  return builder.build("cube");
}

TEST(Meshless, MeanIrradianceOfACubeObeysTheEnergyIdentity) {
  // All faces reflect ρ and one glows: absorbed = emitted gives mean E = π / (6 (1 - ρ)), direct light included.
  for (float albedo : {0.2F, 0.5F, 0.8F}) {
    Solved solved(glowing_floor_cube(albedo), std::nullopt, {{"levels", "4"}});
    const std::vector<SurfaceSample> samples = area_uniform_samples(solved.world(), 6000, 9);
    double mean = 0.0;
    for (const Rgb& value : solved.irradiance(samples, Component::total)) mean += static_cast<double>(value.r) / 6000.0;
    const double exact = pi_double / (6.0 * (1.0 - static_cast<double>(albedo)));
    EXPECT_NEAR(mean, exact, 0.01 * exact) << albedo;
  }
}

TEST(Meshless, OneBounceBetweenParallelPlatesHasAClosedForm) {
  // Sunlight falls on the floor at 45° through the open side; the ceiling gets E ρ F once, F the form factor of the
  // opposed unit square seen from the centre of the ceiling, and nothing else.
  made::SceneBuilder builder;
  const std::uint32_t grey = builder.diffuse("grey", Rgb(0.4F));
  builder.quad("floor", grey, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("ceiling", grey, {{{0, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}}});
  const float s = 3.0F / std::sqrt(10.0F), c = 1.0F / std::sqrt(10.0F);
  builder.light(DirectionalLight{{-s, -c, 0.0F}, Rgb(2.0F)});
  // Of 2048 rays 490 meet the floor, whose edge crosses 2.5 √2048 = 113 cells of the pattern, each right to within 1/√6 of a ray:
  // 0.9%. The basis takes the mean of four or five such gathers, 0.42%; four of these.
  Solved solved(builder.build("plates"), 1);
  const double form_factor = 4.0 / std::sqrt(5.0) / pi_double * std::atan(1.0 / std::sqrt(5.0));
  const auto expected = static_cast<float>(static_cast<double>(2.0F * c) * 0.4 * form_factor);
  EXPECT_NEAR(solved.at({0.5F, 1, 0.5F}, {0, -1, 0}).r, expected, 0.017F * expected);
}

/// Relative difference of two solutions, root mean square and mean, in the green channel.
std::pair<double, double> difference(Solved& one, Solved& other, std::size_t count) {
  const std::vector<SurfaceSample> samples = area_uniform_samples(one.world(), count, 12);
  const std::vector<Rgb> a = one.irradiance(samples), b = other.irradiance(samples);
  double squares = 0.0, sum = 0.0, bias = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const auto apart = static_cast<double>(a[i].g - b[i].g);
    squares += apart * apart, bias += apart, sum += static_cast<double>(a[i].g);
  }
  return {std::sqrt(squares * static_cast<double>(count)) / sum, bias / sum};
}

TEST(Meshless, BouncesOnCoarseLevelsAgreeWithThoseRefinedOneByOne) {
  for (const std::optional<int>& bounces : {std::optional<int>(1), std::optional<int>(3), std::optional<int>()}) {
    Solved coarse(made::box_scene(), bounces, {{"levels", "4"}}),
        refined(made::box_scene(), bounces, {{"levels", "4"}, {"bounce_levels", "0"}});
    const auto [apart, bias] = difference(coarse, refined, 2000);
    EXPECT_LT(apart, 0.04) << bounces.value_or(0);
    EXPECT_LT(std::fabs(bias), 0.01) << bounces.value_or(0);
    EXPECT_EQ(coarse.lit.termination, refined.lit.termination);
    if (bounces) {
      EXPECT_EQ(coarse.lit.counters["bounces"], static_cast<std::uint64_t>(*bounces));
    }
  }
}

TEST(Meshless, OneGatherServesAllBounces) {
  const Setting all_asked{{"levels", "3"}, {"rays", "128"}, {"residual", "1e-9"}, {"epsilon_E", "9"}};
  Solved two(furnace(Rgb(0.5F)), 2, all_asked), many(furnace(Rgb(0.5F)), 12, all_asked);
  EXPECT_EQ(many.lit.counters["bounces"], 12U);
  EXPECT_EQ(two.lit.counters["samples_gathered"], many.lit.counters["samples_gathered"]);
  EXPECT_EQ(two.lit.counters["closest_hit_rays"], many.lit.counters["closest_hit_rays"]);
}

/// Points of the last level whose functions reach no point of the level before: no refinement asks for them.
std::size_t out_of_reach(const meshless::Hierarchy& hierarchy) {
  const std::uint32_t last = hierarchy.levels() - 1;
  std::set<std::uint32_t> reached;
  for (std::uint32_t point = hierarchy.level_begin(last - 1); point < hierarchy.level_begin(last); ++point)
    hierarchy.visit_uncut(last, hierarchy.place(point), [&](std::uint32_t child, float) { reached.insert(child); });
  return hierarchy.level_size(last) - reached.size();
}

TEST(Meshless, FineGathersTakeFewerRaysWhereThresholdsGrow) {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("grey", Rgb(0.5F)), {0, 0, 0}, {1, 1, 1});
  builder.light(PointLight{{0.4F, 0.6F, 0.5F}, Rgb(1.0F)});
  const Scene scene = builder.build("room");
  const auto setting = [](const char* growth) {
    return Setting{
        {"levels", "4"}, {"coarsest_samples", "50"}, {"epsilon_E", "0"}, {"noise_guard", "0"}, {"level_growth", growth}};
  };
  // Every point gathers that is in reach: with 512 rays on both fine levels, or 294 on the last.
  Solved even(scene, 1, setting("1")), falling(scene, 1, setting("2"));
  const meshless::test::BasisScene basis(scene, meshless::settings_from(Parameters(meshless::settings_schema(), setting("1"))));
  ASSERT_EQ(even.prepared.counters["samples"], basis.hierarchy.size());
  EXPECT_EQ(even.lit.counters["samples_gathered"], basis.hierarchy.size() - out_of_reach(basis.hierarchy));
  EXPECT_EQ(even.lit.counters["samples_gathered"], falling.lit.counters["samples_gathered"]);
  EXPECT_LT(falling.lit.counters["closest_hit_rays"], even.lit.counters["closest_hit_rays"] * 17 / 20);
  const auto [apart, bias] = difference(falling, even, 500);
  EXPECT_LT(apart, 0.03);
}

TEST(Meshless, BothFirstBouncesAgree) {
  Solved exact(made::box_scene(), 2, {{"levels", "5"}}),
      basis(made::box_scene(), 2, {{"levels", "5"}, {"first_bounce", "basis"}});
  const auto [apart, bias] = difference(exact, basis, 2000);
  EXPECT_LT(apart, 0.05);
  EXPECT_LT(std::fabs(bias), 0.01);
}

TEST(Meshless, DirectLightInTheBasisIsNearTheEvaluator) {
  Solved basis(made::box_scene(), 1, {{"direct", "basis"}}), shared(made::box_scene(), 1);
  EXPECT_TRUE(basis.method().capabilities().direct);
  EXPECT_FALSE(shared.method().capabilities().direct);
  const std::vector<SurfaceSample> samples = area_uniform_samples(basis.world(), 1000, 2);
  const std::vector<Rgb> a = basis.irradiance(samples, Component::direct), b = shared.irradiance(samples, Component::direct);
  double squares = 0.0, reference = 0.0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    squares += std::pow(static_cast<double>(a[i].r - b[i].r), 2);
    reference += std::pow(static_cast<double>(b[i].r), 2);
  }
  EXPECT_LT(std::sqrt(squares / reference), 0.1);
}

TEST(Meshless, ADarkRoomBehindAThinWallStaysDark) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.7F)), lamp = builder.diffuse("lamp", Rgb(0.0F), Rgb(10.0F));
  builder.room("lit", white, {0, 0, 0}, {1, 1, 1}).room("dark", white, {1.001F, 0, 0}, {2, 1, 1});
  builder.quad("lamp", lamp, {{{0.4F, 0.99F, 0.4F}, {0.6F, 0.99F, 0.4F}, {0.6F, 0.99F, 0.6F}, {0.4F, 0.99F, 0.6F}}});
  Solved solved(builder.build("rooms"), std::nullopt, rough);
  std::size_t dark = 0;
  const std::vector<SurfaceSample> samples = area_uniform_samples(solved.world(), 600, 5);
  const std::vector<Rgb> values = solved.irradiance(samples);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (samples[i].position.x <= 1.0005F) continue;
    EXPECT_EQ(values[i], Rgb());
    ++dark;
  }
  EXPECT_GT(dark, 100U);
}

TEST(Meshless, AnswersTwoSidedFacesOnBothSidesAndBacksWithBlack) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.room("room", white, {0, 0, 0}, {1, 1, 1});
  builder.quad("shelf", white, {{{0.3F, 0.5F, 0.3F}, {0.3F, 0.5F, 0.7F}, {0.7F, 0.5F, 0.7F}, {0.7F, 0.5F, 0.3F}}}, true);
  builder.light(PointLight{{0.5F, 0.8F, 0.5F}, Rgb(1.0F)});
  Solved solved(builder.build("shelf"), std::nullopt, rough);
  const Rgb above = solved.at({0.5F, 0.5F, 0.5F}, {0, 1, 0}), below = solved.at({0.5F, 0.5F, 0.5F}, {0, -1, 0});
  EXPECT_GT(below.r, 0.05F);
  EXPECT_GT(above.r, 1.2F * below.r);
  SurfaceSample back = solved.sample({0.5F, 0.0F, 0.5F}, {0, 1, 0});
  back.normal = -back.normal;
  back.lit_side = false;
  EXPECT_EQ(solved.irradiance({back})[0], Rgb());
}

TEST(Meshless, RadianceIsTheReflectedShareOfTheIrradiance) {
  Solved solved(made::box_scene(), 2, rough);
  const std::vector<SurfaceSample> samples = area_uniform_samples(solved.world(), 100, 6);
  std::vector<Vec3> toward;
  for (const SurfaceSample& sample : samples) toward.push_back(sample.normal);
  const std::vector<Rgb> irradiance = solved.irradiance(samples);
  std::vector<Rgb> radiance(samples.size());
  Task task;
  EXPECT_TRUE(
      succeeded(solved.method().shade({Quantity::radiance, samples, toward}, {{}, radiance, {}, {}, {}}, task).termination));
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Rgb albedo = solved.world().scene().material_of_object(samples[i].object).diffuse;
    for (int channel = 0; channel < 3; ++channel)
      EXPECT_NEAR(radiance[i][channel], albedo[channel] * irradiance[i][channel] / pi, 1e-6F);
  }
}

TEST(Meshless, TheSameSeedGivesTheSameBitsOnOneAndTwoThreads) {
  Solved one(made::box_scene(), 2, rough, 1), two(made::box_scene(), 2, rough, 2);
  const std::vector<SurfaceSample> samples = area_uniform_samples(one.world(), 500, 1);
  EXPECT_EQ(one.irradiance(samples), two.irradiance(samples));
  EXPECT_EQ(one.lit.counters.values(), two.lit.counters.values());
}

TEST(Meshless, ComputesNothingThatIsNotCalledFor) {
  Solved none(made::box_scene(), 0);
  EXPECT_EQ(none.prepared.counters["samples"], 0U);
  EXPECT_EQ(none.lit.counters["samples_gathered"], 0U);
  EXPECT_EQ(none.lit.counters["closest_hit_rays"], 0U);
  EXPECT_EQ(none.at({0.5F, 0, 0.9F}, {0, 1, 0}), Rgb());
  made::BoxOptions dark;
  dark.lamp_emission = Rgb();
  Solved unlit{made::box_scene(dark)};
  EXPECT_EQ(unlit.lit.counters["samples_gathered"], 0U);
  EXPECT_EQ(unlit.at({0.5F, 0, 0.9F}, {0, 1, 0}), Rgb());
}

TEST(Meshless, ReportsItsWork) {
  Solved solved(made::box_scene());
  EXPECT_EQ(solved.prepared.counters["levels"], 6U);
  EXPECT_NEAR(static_cast<double>(solved.prepared.counters["coarsest_samples"]), 310.0, 20.0);
  const std::uint64_t gathered = solved.lit.counters["samples_gathered"];
  EXPECT_GE(gathered, solved.lit.counters["coarse_functions"]);
  EXPECT_GE(solved.lit.counters["coarse_functions"], 3U * 290U)
      << "two levels, of which the second has about twice to three times the points";
  EXPECT_LE(gathered, solved.prepared.counters["samples"]) << "no point gathers twice";
  EXPECT_EQ(solved.lit.counters["basis_functions"], gathered);
  EXPECT_GE(solved.lit.counters["closest_hit_rays"], 228U * gathered) << "512 / 1.4^(4/5 · 3) on the finest level";
  EXPECT_GT(solved.method().bytes(), 1'000'000U);
  EXPECT_EQ(solved.lit.termination, Termination::converged);
  double last = 0.0;
  for (const ProgressPoint& point : solved.prepared.history) {
    EXPECT_GE(point.done, last);
    last = point.done;
  }
  EXPECT_DOUBLE_EQ(last, 1.0);
}

TEST(Meshless, RefusesScenesWithoutArea) {
  const MethodEntry entry = meshless_entry();
  const auto method = make_session(entry, Parameters(entry.schema, {}));
  EXPECT_TRUE(method->refusal(Scene{}).has_value());
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.object("needle", white, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2, 2}});
  EXPECT_TRUE(method->refusal(builder.build("needle")).has_value());
  EXPECT_FALSE(method->refusal(made::box_scene()).has_value());
}

TEST(Meshless, LivesWithDegenerateFacesFlippedNormalsAndASingleTriangle) {
  Scene flipped = made::box_scene();
  for (std::size_t face = 0; face < flipped.faces.size(); face += 2)
    std::swap(flipped.faces[face].corners[0], flipped.faces[face].corners[2]);
  tessellate(flipped);
  made::SceneBuilder single;
  single.object("triangle", single.diffuse("white", Rgb(0.5F), Rgb(1.0F)), {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2, 2}});
  made::SceneBuilder needles;
  const std::uint32_t white = needles.diffuse("white", Rgb(0.5F), Rgb(1.0F));
  needles.room("room", white, {0, 0, 0}, {1, 1, 1});
  needles.object("needle", white, {{0.2F, 0.2F, 0.2F}, {0.8F, 0.8F, 0.8F}, {0.5F, 0.5F, 0.5F}, {0.2F, 0.2F, 0.2F}},
                 {{0, 1, 2, 2}, {0, 3, 1, 1}});
  for (const Scene& scene : {flipped, single.build("single"), needles.build("needles")}) {
    Solved solved(scene, 2, {{"levels", "4"}});
    for (const Rgb& value : solved.irradiance(area_uniform_samples(solved.world(), 300, 3), Component::total)) {
      EXPECT_TRUE(is_finite(value));
      EXPECT_GE(smallest(value), 0.0F);
      EXPECT_LT(largest(value), 1e3F);
    }
  }
}

TEST(Meshless, StopsWhenCancelled) {
  const World world(made::box_scene());
  const MethodEntry entry = meshless_entry();
  const auto method = make_session(entry, Parameters(entry.schema, rough));
  TaskSettings settings;
  settings.cancel = std::make_shared<std::atomic<bool>>(false);
  settings.on_progress = [cancel = settings.cancel](const ProgressPoint& point) {
    if (point.step == "bounce 1") *cancel = true;
  };
  Task task(settings);
  EffectPlan plan;
  plan.simulated = {Effect::diffuse_indirect};
  EXPECT_TRUE(succeeded(method->prepare(world, plan, task).termination));
  const StageReport report = method->light(Lighting::of(world.scene()), task);
  EXPECT_EQ(report.termination, Termination::cancelled);
  EXPECT_LE(report.counters["bounces"], 1U);
}

}  // namespace
}  // namespace gibench::test
