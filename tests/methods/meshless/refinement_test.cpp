#include "methods/meshless/refinement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "common/core/random.h"
#include "common/scene/made_scenes.h"
#include "methods/meshless/expansion.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

test::BasisScene floor_scene(int levels) {
  made::SceneBuilder builder;
  builder.quad("floor", builder.diffuse("white", Rgb(0.5F)), {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  Settings settings = test::default_settings();
  settings.levels = levels;
  return test::BasisScene(builder.build("floor"), settings);
}

template <class Function>
Coefficients refined(const test::BasisScene& scene, const RefinementRule& rule, Function&& function, int threads = 1) {
  TaskSettings task_settings;
  task_settings.threads = threads;
  Task task(task_settings);
  const PointValues values = [&](std::span<const std::uint32_t> points, std::span<Estimate> out) {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = function(points[i]);
  };
  return approximate(scene.hierarchy, values, rule, task);
}

std::size_t computed_on_level(const Coefficients& made, std::uint32_t level) {
  std::size_t count = 0;
  for (std::uint32_t point : made.sorted_points()) count += made.hierarchy().level_of(point) == level ? 1U : 0U;
  return count;
}

RefinementRule rule_with(double epsilon_e) {
  RefinementRule rule;
  rule.epsilon_e = epsilon_e;
  return rule;
}

TEST(Refinement, AConstantStaysOnTheCoarsestLevel) {
  const test::BasisScene scene = floor_scene(4);
  const Coefficients made = refined(scene, rule_with(0.01), [](std::uint32_t) { return Estimate{Rgb(2.0F), 0.0F}; });
  EXPECT_EQ(made.size(), scene.hierarchy.level_size(0));
  EXPECT_NEAR(coarsest_mean(made).g, 2.0, 1e-6);
}

TEST(Refinement, AStepIsRefinedAlongItsEdgeOnly) {
  const test::BasisScene scene = floor_scene(5);
  const auto step = [&](std::uint32_t p) { return Estimate{Rgb(scene.hierarchy.position(p).x < 0.5F ? 0.0F : 1.0F), 0.0F}; };
  const Coefficients made = refined(scene, rule_with(0.02), step);
  EXPECT_GT(computed_on_level(made, 4), 50U);
  EXPECT_LT(computed_on_level(made, 4), scene.hierarchy.level_size(4) / 2U);
  for (std::uint32_t point : made.sorted_points()) {
    if (scene.hierarchy.level_of(point) != 4) continue;
    EXPECT_LT(std::fabs(scene.hierarchy.position(point).x - 0.5F), 0.1F);
  }
  const Expansion expansion(made);
  for (const Place& at : scene.places(500)) {
    if (std::fabs(at.position.x - 0.5F) <= 0.1F) continue;
    EXPECT_NEAR(expansion.evaluate(at).r, at.position.x < 0.5F ? 0.0F : 1.0F, 0.03F);
  }
}

TEST(Refinement, EveryParentOfAComputedFunctionIsComputed) {
  const test::BasisScene scene = floor_scene(4);
  const auto bump = [&](std::uint32_t p) {
    const Vec3& at = scene.hierarchy.position(p);
    return Estimate{Rgb(std::exp(-200.0F * ((at.x - 0.3F) * (at.x - 0.3F) + (at.z - 0.6F) * (at.z - 0.6F)))), 0.0F};
  };
  const Coefficients made = refined(scene, rule_with(0.05), bump);
  EXPECT_GT(computed_on_level(made, 3), 0U);
  for (std::uint32_t point : made.sorted_points())
    for (std::uint32_t level = 0; level < scene.hierarchy.level_of(point); ++level)
      scene.hierarchy.visit_covering(level, scene.hierarchy.place(point),
                                     [&](std::uint32_t parent, float) { EXPECT_TRUE(made.has(parent)); });
}

TEST(Refinement, CoefficientsAreThoseOfEquation10) {
  const test::BasisScene scene = floor_scene(3);
  const auto wave = [&](const Place& at) { return Rgb(std::sin(9.0F * at.position.x)); };
  const Coefficients full = scene.approximate_fully(2, wave);
  const Coefficients made = refined(scene, rule_with(0.0), [&](std::uint32_t p) {
    return Estimate{wave(scene.hierarchy.place(p)), 0.0F};
  });
  EXPECT_GT(made.size(), scene.hierarchy.size() * 9U / 10U);
  for (std::uint32_t point : made.sorted_points()) EXPECT_NEAR(made[point].r, full[point].r, 1e-5F);
}

TEST(Refinement, ASmallerThresholdNeverGivesALargerError) {
  const test::BasisScene scene = floor_scene(5);
  const auto wave = [&](const Place& at) { return Rgb(2.0F + std::sin(9.0F * at.position.x * at.position.z)); };
  double before = 1.0;
  for (double epsilon_e : {0.1, 0.03, 0.01, 0.003}) {
    const Expansion expansion(refined(scene, rule_with(epsilon_e), [&](std::uint32_t p) {
      return Estimate{wave(scene.hierarchy.place(p)), 0.0F};
    }));
    double squares = 0.0;
    const std::vector<Place> places = scene.places(1000);
    for (const Place& at : places) squares += std::pow(static_cast<double>(expansion.evaluate(at).r - wave(at).r), 2);
    const double error = std::sqrt(squares / 1000.0) / 2.0;
    EXPECT_LT(error, before);
    EXPECT_LT(error, epsilon_e);
    before = error;
  }
}

/// A step of a tenth in the middle of a floor, under noise whose deviation is known.
struct NoisyStep {
  const Hierarchy& hierarchy;
  float deviation;

  Estimate operator()(std::uint32_t p) const {
    RandomStream random(1, 0, p);
    const float gauss = std::sqrt(-2.0F * std::log(1.0F - random.next_float())) * std::cos(2.0F * pi * random.next_float());
    return {Rgb((hierarchy.position(p).x < 0.5F ? 1.0F : 1.1F) + deviation * gauss), deviation};
  }
};

struct Refined {
  std::size_t at_step = 0, elsewhere = 0;  ///< functions beyond the coarsest level
  std::uint64_t undecided = 0;
};

Refined refined_step(const test::BasisScene& scene, double epsilon_e, double noise_guard, float deviation) {
  RefinementRule rule = rule_with(epsilon_e);
  rule.noise_guard = noise_guard;
  Task task;
  const NoisyStep step{scene.hierarchy, deviation};
  const PointValues values = [&](std::span<const std::uint32_t> points, std::span<Estimate> out) {
    for (std::size_t i = 0; i < points.size(); ++i) out[i] = step(points[i]);
  };
  const Coefficients made = approximate(scene.hierarchy, values, rule, task);
  Refined result;
  for (const std::uint32_t point : made.sorted_points())
    if (scene.hierarchy.level_of(point) > 0)
      ++(std::fabs(scene.hierarchy.position(point).x - 0.5F) < 0.25F ? result.at_step : result.elsewhere);
  result.undecided = task.counters()["undecided_samples"];
  return result;
}

TEST(Refinement, UnderTheNoiseGuardAStepIsRefinedWhereItStandsOutOfTheNoise) {
  const test::BasisScene scene = floor_scene(4);
  // Noise of a hundredth, a step of ten deviations: noise is chased everywhere without the guard, the step alone with it.
  const Refined chased = refined_step(scene, 0.01, 0.0, 0.01F), guarded = refined_step(scene, 0.01, 5.0, 0.01F);
  EXPECT_GT(chased.elsewhere, scene.hierarchy.size() / 4);
  EXPECT_EQ(chased.undecided, 0U);
  EXPECT_GT(guarded.at_step, 100U);
  EXPECT_LT(guarded.elsewhere, chased.elsewhere / 20);
  EXPECT_GT(guarded.undecided, 0U) << "differences over epsilon_E that may be noise are told";
}

TEST(Refinement, WhereNoiseOverridesEpsilonEThatIsCounted) {
  const test::BasisScene scene = floor_scene(4);
  // The step is two deviations high: whether there is one cannot be known.
  const Refined blind = refined_step(scene, 0.01, 5.0, 0.05F);
  EXPECT_EQ(blind.at_step + blind.elsewhere, 0U);
  EXPECT_GT(blind.undecided, scene.hierarchy.level_size(0) / 2U);
  // Where epsilon_E is above all differences the guard overrides nothing, and where nothing is noisy it decides everything.
  EXPECT_EQ(refined_step(scene, 0.5, 5.0, 0.05F).undecided, 0U);
  EXPECT_EQ(refined_step(scene, 0.01, 5.0, 0.0F).undecided, 0U);
}

TEST(Refinement, TheNoiseGuardLeavesNoiseAlone) {
  const test::BasisScene scene = floor_scene(5);
  const auto noise = [](std::uint32_t p) {
    RandomStream random(1, 0, p);
    return Estimate{Rgb(1.0F + 0.2F * (random.next_float() - 0.5F)), 0.06F};
  };
  RefinementRule rule = rule_with(0.01);
  const std::size_t chased = refined(scene, rule, noise).size();
  rule.noise_guard = 3.0;  // two values differ by 0.2 at most, 2.4 of their deviations
  const std::size_t guarded = refined(scene, rule, noise).size();
  EXPECT_GT(chased, scene.hierarchy.size() * 9 / 10);
  EXPECT_EQ(guarded, scene.hierarchy.level_size(0));
}

TEST(Refinement, TheReferenceForeseesTheTermsLeft) {
  // Detail of 3% of the term does not count as detail where 9 more terms of the same size are to come.
  const test::BasisScene scene = floor_scene(3);
  const auto ripple = [&](std::uint32_t p) {
    return Estimate{Rgb(1.0F + (scene.hierarchy.position(p).x < 0.5F ? 0.0F : 0.03F)), 0.0F};
  };
  RefinementRule rule = rule_with(0.02);
  EXPECT_GT(refined(scene, rule, ripple).size(), scene.hierarchy.level_size(0));
  rule.previous_mean = 1.1;
  rule.terms_left = 9;
  EXPECT_EQ(refined(scene, rule, ripple).size(), scene.hierarchy.level_size(0));
  rule.previous_mean = 0.0;
  rule.solution_mean = 9.0;
  EXPECT_EQ(refined(scene, rule, ripple).size(), scene.hierarchy.level_size(0));
}

TEST(Refinement, DarkSurfacesDoNotDiluteAMeanWeightedByIrradiance) {
  // A tenth of the floor is lit, by 1 and by 1.05: a ripple of 50% of the mean over the area, and 5% of that over the light.
  const test::BasisScene scene = floor_scene(3);
  const auto lit = [&](std::uint32_t p) {
    const Vec3& at = scene.hierarchy.position(p);
    return Estimate{Rgb(at.x > 0.1F ? 0.0F : (at.z < 0.5F ? 1.0F : 1.05F)), 0.0F, 0.0F};
  };
  const auto computed_along_ripple = [&](const Coefficients& made) {
    std::size_t count = 0;
    for (const std::uint32_t p : made.sorted_points())
      count += scene.hierarchy.level_of(p) == 2 && scene.hierarchy.position(p).x < 0.03F ? 1U : 0U;
    return count;
  };
  RefinementRule rule = rule_with(0.2);
  const std::size_t by_area = computed_along_ripple(refined(scene, rule, lit));
  rule.threshold_mean = ThresholdMean::irradiance;
  EXPECT_LT(computed_along_ripple(refined(scene, rule, lit)), by_area);
  rule.epsilon_e = 0.02;
  EXPECT_GT(computed_along_ripple(refined(scene, rule, lit)), 0U) << "a ripple of 5% is over 2%";
}

TEST(Refinement, AMeanWeightedByIrradianceIsTheMeanWhereAllIsEven) {
  const test::BasisScene scene = floor_scene(3);
  const auto step = [&](std::uint32_t p) {
    return Estimate{Rgb(scene.hierarchy.position(p).x < 0.5F ? 1.0F : 1.03F), 0.0F, 0.0F};
  };
  for (const double epsilon_e : {0.025, 0.035}) {
    RefinementRule rule = rule_with(epsilon_e);
    rule.threshold_mean = ThresholdMean::irradiance;
    EXPECT_EQ(refined(scene, rule, step).size() > scene.hierarchy.level_size(0), epsilon_e < 0.03) << epsilon_e;
  }
}

TEST(Refinement, NearSurroundingsAreRefinedDownToTheirScale) {
  // Even light along a wall at x = 0 that would explain a slope of 1/x: light may vary by radius / x within a ball. The finest
  // balls are called for where their parents' x is below 0.1 radius / 0.02, five radii; children lie a radius and a half further
  // at most.
  const test::BasisScene scene = floor_scene(4);
  const auto even = [&](std::uint32_t p) {
    return Estimate{Rgb(1.0F), 0.0F, 1.0F / std::max(1e-4F, scene.hierarchy.position(p).x)};
  };
  RefinementRule rule = rule_with(0.02);
  EXPECT_EQ(refined(scene, rule, even).size(), scene.hierarchy.level_size(0)) << "there is no variation";
  rule.proximity = 0.1;
  const Coefficients made = refined(scene, rule, even);
  float farthest = 0.0F, largest_parent = 0.0F;
  std::size_t finest = 0, beside_wall = 0;
  for (std::uint32_t p = scene.hierarchy.level_begin(2); p < scene.hierarchy.level_begin(3); ++p)
    largest_parent = std::max(largest_parent, scene.hierarchy.radius(p));
  for (std::uint32_t p = scene.hierarchy.level_begin(3); p < scene.hierarchy.size(); ++p) {
    const float x = scene.hierarchy.position(p).x;
    beside_wall += x < 0.02F ? 1U : 0U;
    if (!made.has(p)) continue;
    farthest = std::max(farthest, x);
    finest += x < 0.02F ? 1U : 0U;
  }
  EXPECT_EQ(finest, beside_wall);
  EXPECT_GT(finest, 10U);
  EXPECT_LT(farthest, 6.5F * largest_parent);
}

TEST(Refinement, AThresholdThatGrowsFromLevelToLevelLeavesFinerFunctionsOut) {
  const test::BasisScene scene = floor_scene(5);
  const auto step = [&](std::uint32_t p) { return Estimate{Rgb(scene.hierarchy.position(p).x < 0.5F ? 1.0F : 1.2F), 0.0F}; };
  RefinementRule rule = rule_with(0.02);
  const std::size_t even = computed_on_level(refined(scene, rule, step), 4);
  rule.level_growth = 1.5;
  const Coefficients made = refined(scene, rule, step);
  EXPECT_LT(computed_on_level(made, 4), even);
  EXPECT_GT(computed_on_level(made, 1), 0U);
  rule.level_growth = 4.0;
  EXPECT_EQ(computed_on_level(refined(scene, rule, step), 4), 0U) << "0.02 · 4³ is more than the step";
}

TEST(Refinement, IsTheSameForAnyNumberOfThreads) {
  const test::BasisScene scene = floor_scene(5);
  const auto step = [&](std::uint32_t p) { return Estimate{Rgb(scene.hierarchy.position(p).x < 0.4F ? 0.1F : 1.0F), 0.0F}; };
  const Coefficients one = refined(scene, rule_with(0.02), step, 1), two = refined(scene, rule_with(0.02), step, 2);
  ASSERT_EQ(one.sorted_points(), two.sorted_points());
  for (std::uint32_t point : one.sorted_points()) EXPECT_EQ(one[point], two[point]);
}

}  // namespace
}  // namespace gibench::meshless
