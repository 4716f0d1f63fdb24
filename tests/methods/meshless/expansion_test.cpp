#include "methods/meshless/expansion.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "common/scene/made_scenes.h"
#include "tests/methods/meshless/basis_scene.h"

namespace gibench::meshless {
namespace {

constexpr float far_away = 1e6F;  // metres: from there every ball subtends next to nothing

Settings settings_with(int levels) {
  Settings settings = test::default_settings();
  settings.levels = levels;
  settings.grouping = Grouping::components;
  return settings;
}

Scene closed_box() {
  made::SceneBuilder builder;
  builder.room("room", builder.diffuse("white", Rgb(0.5F)), {0, 0, 0}, {1, 1, 1});
  return builder.build("box");
}

Rgb smooth(const Place& at) {
  const Vec3& p = at.position;
  return {1.0F + std::sin(2.0F * p.x + p.y), std::cos(3.0F * p.z), p.x * p.y + 0.5F * p.z};
}

double relative_rmse(const Expansion& expansion, const std::vector<Place>& places) {
  double squares = 0.0, reference = 0.0;
  for (const Place& at : places)
    for (int channel = 0; channel < 3; ++channel) {
      const double error = static_cast<double>(expansion.evaluate(at)[channel] - smooth(at)[channel]);
      squares += error * error;
      reference += std::pow(static_cast<double>(smooth(at)[channel]), 2);
    }
  return std::sqrt(squares / reference);
}

TEST(Expansion, TheBasisFunctionsOfALevelSumToOne) {
  const test::BasisScene scene(closed_box(), settings_with(3));
  for (std::uint32_t level = 0; level < 3; ++level) {
    Coefficients ones(scene.hierarchy);
    for (std::uint32_t p = scene.hierarchy.level_begin(level); p < scene.hierarchy.level_begin(level + 1); ++p)
      ones.set(p, Rgb(1.0F, 2.0F, 3.0F));
    const Expansion expansion(ones);
    for (const Place& at : scene.places(300)) {
      const Rgb value = expansion.evaluate(at);
      EXPECT_NEAR(value.r, 1.0F, 1e-5F);
      EXPECT_NEAR(value.g, 2.0F, 2e-5F);
      EXPECT_NEAR(value.b, 3.0F, 3e-5F);
    }
  }
}

TEST(Expansion, AConstantNeedsTheCoarsestLevelOnly) {
  const test::BasisScene scene(closed_box(), settings_with(3));
  const Coefficients made = scene.approximate_fully(2, [](const Place&) { return Rgb(0.7F); });
  for (std::uint32_t p = scene.hierarchy.level_begin(1); p < scene.hierarchy.size(); ++p) EXPECT_NEAR(made[p].r, 0.0F, 1e-6F);
  const Expansion expansion(made);
  for (const Place& at : scene.places(300)) EXPECT_NEAR(expansion.evaluate(at).g, 0.7F, 1e-5F);
}

TEST(Expansion, ConvergesForASmoothFunctionLevelByLevel) {
  const test::BasisScene scene(closed_box(), settings_with(4));
  const std::vector<Place> places = scene.places(1500);
  double before = std::numeric_limits<double>::infinity();
  for (std::uint32_t level = 0; level < 4; ++level) {
    const double error = relative_rmse(Expansion(scene.approximate_fully(level, smooth)), places);
    EXPECT_LT(error, level == 0 ? 0.1 : 0.5 * before) << level;
    before = error;
  }
  EXPECT_LT(before, 0.005);
}

TEST(Expansion, TheFineCoefficientsOfASmoothFunctionFade) {
  const test::BasisScene scene(closed_box(), settings_with(4));
  const Coefficients made = scene.approximate_fully(3, smooth);
  double before = std::numeric_limits<double>::infinity();
  for (std::uint32_t level = 0; level < 4; ++level) {
    double sum = 0.0;
    for (std::uint32_t p = scene.hierarchy.level_begin(level); p < scene.hierarchy.level_begin(level + 1); ++p)
      sum += static_cast<double>(std::fabs(made[p].r));
    const double mean = sum / scene.hierarchy.level_size(level);
    EXPECT_LT(mean, 0.6 * before);
    before = mean;
  }
}

TEST(Expansion, IsTheSumThatTheCoefficientsGive) {
  const test::BasisScene scene(made::box_scene(), settings_with(3));
  Coefficients some(scene.hierarchy);  // every third function only, so that parts of the levels are left out
  for (std::uint32_t p = 0; p < scene.hierarchy.size(); p += p < scene.hierarchy.level_begin(1) ? 1U : 3U)
    some.set(p, smooth(scene.hierarchy.place(p)));
  const Expansion expansion(some);
  std::uint64_t levels = 0;
  for (const Place& at : scene.places(500)) {
    const Rgb expected = some.evaluate(at, 2), value = expansion.evaluate(at);
    const Rgb near = expansion.evaluate_seen(at, at.position + 1e-3F * at.normal, 1e-9F, levels);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_NEAR(value[channel], expected[channel], 1e-5F);
      EXPECT_NEAR(near[channel], expected[channel], 1e-5F);
    }
  }
}

TEST(Expansion, FarReceiversSeeTheCoarsestLevel) {
  const test::BasisScene scene(closed_box(), settings_with(3));
  const Coefficients made = scene.approximate_fully(2, smooth);
  const Expansion expansion(made);
  for (const Place& at : scene.places(100)) {
    std::uint64_t levels = 0;
    const Rgb value = expansion.evaluate_seen(at, at.position + far_away * at.normal, 0.01F, levels);
    EXPECT_EQ(levels, 1U);
    EXPECT_NEAR(value.r, made.evaluate(at, 0).r, 1e-5F);
  }
}

TEST(Expansion, TheSenderLevelFollowsTheSolidAngleOfTheBalls) {
  const test::BasisScene scene(closed_box(), settings_with(3));
  const Expansion expansion(scene.approximate_fully(2, smooth));
  const Place at = scene.places(1)[0];
  double covering = 0.0, mean_radius = 0.0;
  scene.hierarchy.visit_covering(0, at, [&](std::uint32_t p, float) {
    covering += 1.0;
    mean_radius += static_cast<double>(scene.hierarchy.radius(p));
  });
  mean_radius /= covering;
  // A ball of radius r at distance d subtends 2π (1 - √(1 - r²/d²)): π r²/d² from afar.
  const auto distance = static_cast<float>(30.0 * mean_radius);
  const float angle = pi / 900.0F;
  std::uint64_t above = 0, below = 0;
  expansion.evaluate_seen(at, at.position + distance * at.normal, 1.3F * angle, above);
  expansion.evaluate_seen(at, at.position + distance * at.normal, angle / 1.3F, below);
  EXPECT_EQ(above, 1U);
  EXPECT_EQ(below, 2U);
}

TEST(Expansion, WhereNothingCoversALevelContributesNothing) {
  made::BoxOptions empty;
  empty.blocks = false;  // so that only the front wall, a metre away, faces as the back of the back wall does
  const test::BasisScene scene(made::box_scene(empty), settings_with(2));
  const Expansion expansion(scene.approximate_fully(1, smooth));
  std::uint64_t levels = 0;
  const Place on_floor = scene.places(1)[0];
  Place outside = on_floor, backwards = on_floor;
  outside.position += 100.0F;
  backwards.position = {0.5F, 0.5F, 0.0F};
  backwards.normal = {0.0F, 0.0F, -1.0F};  // the back of the back wall
  for (const Place& at : {outside, backwards}) {
    EXPECT_EQ(expansion.evaluate(at), Rgb());
    EXPECT_EQ(expansion.evaluate_seen(at, {0, 0, 0}, 0.1F, levels), Rgb());
  }
  EXPECT_EQ(levels, 0U);
}

TEST(Expansion, ReachesNoOtherGroup) {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", Rgb(0.5F));
  builder.quad("left", white, {{{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}}});
  builder.quad("right", white, {{{1.001F, 0, 0}, {1.001F, 0, 1}, {2, 0, 1}, {2, 0, 0}}});
  const test::BasisScene scene(builder.build("two floors"), settings_with(2));
  Coefficients left(scene.hierarchy);
  for (std::uint32_t p = 0; p < scene.hierarchy.size(); ++p)
    if (scene.hierarchy.position(p).x < 1.0005F && scene.hierarchy.level_of(p) == 0) left.set(p, Rgb(1.0F));
  const Expansion expansion(left);
  for (const Place& at : scene.places(200)) EXPECT_NEAR(expansion.evaluate(at).r, at.position.x < 1.0005F ? 1.0F : 0.0F, 1e-5F);
}

TEST(Expansion, NothingLeaksRoundARightAngleInATurnedScene) {
  const Scene turned = made::transformed(closed_box(), 1.0F, {1.0F, 2.0F, 3.0F}, 37.0F);
  const test::BasisScene scene(turned, settings_with(1));
  const Vec3 up = scene.hierarchy.normal(0);
  Coefficients one_wall(scene.hierarchy);
  for (std::uint32_t p = 0; p < scene.hierarchy.size(); ++p)
    if (glm::dot(scene.hierarchy.normal(p), up) > 0.9F) one_wall.set(p, Rgb(1.0F));
  const Expansion expansion(one_wall);
  for (const Place& at : scene.places(500)) {
    const bool on_wall = glm::dot(at.normal, up) > 0.9F;
    EXPECT_NEAR(expansion.evaluate(at).r, on_wall ? 1.0F : 0.0F, 1e-5F);
  }
}

}  // namespace
}  // namespace gibench::meshless
