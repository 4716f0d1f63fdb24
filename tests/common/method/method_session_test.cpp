/// The work of a session around a method, on a method whose behaviour each test sets.
#include "common/method/method_session.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/scene/made_scenes.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

/// Answers 1 + index everywhere unless the test says otherwise.
class ScriptedMethod : public TransportMethod {
 public:
  Capabilities can{
      {Effect::direct, Effect::diffuse_indirect}, {Quantity::radiance, Quantity::irradiance}, true, true, true, false};
  Termination prepare_ends = Termination::done, light_ends = Termination::done;
  std::function<void(const ShadeAnswer&)> shading = [](const ShadeAnswer&) {};
  int prepared = 0, lit = 0;
  EffectSet prepared_for;

  Capabilities capabilities() const noexcept override { return can; }

  void prepare(const World&, const EffectPlan& plan, Task& task, StageReport& report) override {
    ++prepared;
    prepared_for = plan.simulated;
    task.count("nodes", 3);
    task.progress("nodes", 1.0);
    report.termination = prepare_ends;
  }
  void light(const PlannedLights&, Task&, StageReport& report) override {
    ++lit;
    report.termination = light_ends;
  }
  void shade(const ShadeRequest&, const ShadeAnswer& answer, Task&, StageReport&) const override {
    for (std::span<Rgb> values : {answer.direct, answer.indirect, answer.direct_variance, answer.indirect_variance})
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = Rgb(static_cast<float>(1 + i));
    shading(answer);
  }
};

class Session : public testing::Test {
 protected:
  Session() : world(made::box_scene(), 1), lighting(Lighting::of(world.scene())) {
    samples = area_uniform_samples(world, 10, 1);
    for (const SurfaceSample& sample : samples) normals.push_back(sample.normal);
    direct.resize(samples.size());
    indirect.resize(samples.size());
  }
  void make_ready() {
    ASSERT_TRUE(succeeded(session.prepare(world, {}, task).termination));
    ASSERT_TRUE(succeeded(session.light(lighting, task).termination));
  }
  StageReport shade(Quantity quantity = Quantity::irradiance) {
    const bool viewed = quantity == Quantity::radiance;
    return session.shade({quantity, samples, viewed ? std::span<const Vec3>(normals) : std::span<const Vec3>()},
                         {direct, indirect, {}, {}, {}}, task);
  }

  World world;
  Lighting lighting;
  std::unique_ptr<ScriptedMethod> made = std::make_unique<ScriptedMethod>();
  ScriptedMethod& method = *made;
  MethodSession session{std::move(made)};
  Task task;
  std::vector<SurfaceSample> samples;
  std::vector<Vec3> normals;
  std::vector<Rgb> direct, indirect;
};

TEST_F(Session, ThePublicCallsComeInOrder) {
  EXPECT_THAT([&] { session.light(lighting, task); }, test::fails_check("after a prepare"));
  EXPECT_THAT([&] { shade(); }, test::fails_check("after a light"));
  session.prepare(world, {}, task);
  EXPECT_THAT([&] { shade(); }, test::fails_check("after a light"));
  EXPECT_THAT([&] { session.light(Lighting{}, task); }, test::fails_check("one emission for each material"));
}

TEST_F(Session, AStageThatFailedCannotBeBuiltOn) {
  method.prepare_ends = Termination::out_of_budget;
  EXPECT_EQ(session.prepare(world, {}, task).termination, Termination::out_of_budget);
  EXPECT_THAT([&] { session.light(lighting, task); }, test::fails_check("after a prepare"));
  method.prepare_ends = Termination::done;
  method.light_ends = Termination::not_converged;
  session.prepare(world, {}, task);
  EXPECT_EQ(session.light(lighting, task).termination, Termination::not_converged);
  EXPECT_THAT([&] { shade(); }, test::fails_check("after a light"));
}

TEST_F(Session, SizesAndQuantitiesAreChecked) {
  make_ready();
  std::vector<Rgb> few(samples.size() - 1);
  EXPECT_THAT(
      [&] {
        session.shade({Quantity::irradiance, samples, {}}, {few, {}, {}, {}, {}}, task);
      },
      test::fails_check("one value for each sample"));
  EXPECT_THAT(
      [&] {
        session.shade({Quantity::irradiance, samples, {}}, {{}, {}, few, {}, {}}, task);
      },
      test::fails_check("one variance for each"));
  EXPECT_THAT(
      [&] {
        session.shade({Quantity::radiance, samples, {}}, {direct, {}, {}, {}, {}}, task);
      },
      test::fails_check("one direction for each"));
  EXPECT_THAT([&] { shade(Quantity::accessibility); }, test::fails_check("only for quantities that it answers"));
  EXPECT_THAT(
      [&] {
        session.shade({Quantity::radiosity, samples, {}}, {direct, {}, indirect, {}, {}}, task);
      },
      test::fails_check("methods that know it"));
  method.can.variance = false;
  EXPECT_THAT(
      [&] {
        session.shade({Quantity::irradiance, samples, {}}, {direct, {}, indirect, {}, {}}, task);
      },
      test::fails_check("methods that know it"));
}

TEST_F(Session, EveryValueThatWasWrittenIsHandedOn) {
  make_ready();
  EXPECT_EQ(shade().termination, Termination::done);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(direct[i], Rgb(static_cast<float>(1 + i)));
}

TEST_F(Session, AValueThatWasNotWrittenIsTold) {
  make_ready();
  method.shading = [](const ShadeAnswer& answer) { answer.indirect[4] = Rgb(std::numeric_limits<float>::quiet_NaN()); };
  const StageReport report = shade();
  EXPECT_EQ(report.termination, Termination::invalid_output);
  EXPECT_EQ(report.message, "indirect light of sample 4 was not written or is not finite");
}

TEST_F(Session, AnswersAreFilledWithNanBeforeTheWork) {
  make_ready();
  direct.assign(samples.size(), Rgb(7.0F));
  bool holds_nan = true;
  method.shading = [&](const ShadeAnswer& answer) { holds_nan = std::isnan(answer.total_variance[0].r); };
  std::vector<Rgb> total_variance(samples.size());
  const StageReport report = session.shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, total_variance}, task);
  EXPECT_TRUE(holds_nan) << "the method saw what the caller had left";
  EXPECT_EQ(report.termination, Termination::invalid_output) << "nobody wrote the total variance";
}

TEST_F(Session, AnInfiniteValueIsTold) {
  make_ready();
  method.shading = [](const ShadeAnswer& answer) { answer.direct[0].g = INFINITY; };
  EXPECT_EQ(shade().termination, Termination::invalid_output);
}

TEST_F(Session, StagesReportTheirOwnCountsAndHistory) {
  const StageReport first = session.prepare(world, {}, task), second = session.prepare(world, {}, task);
  EXPECT_EQ(first.counters["nodes"], 3U);
  EXPECT_EQ(second.counters["nodes"], 3U);
  EXPECT_EQ(second.history.size(), 1U);
  EXPECT_GE(second.seconds, 0.0);
  EXPECT_EQ(task.counters()["nodes"], 6U);
}

TEST_F(Session, RelightingDoesNotPrepareAgain) {
  make_ready();
  session.light(lighting, task);
  EXPECT_EQ(method.prepared, 1);
  EXPECT_EQ(method.lit, 2);
}

TEST_F(Session, AnEditPreparesAndLightsAgainByDefault) {
  make_ready();
  made::BoxOptions options;
  options.blocks = false;
  const World after(made::box_scene(options), 1);
  const SceneEdit edit = MoveEdit{"tall", {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(session.edit(edit, after, Lighting::of(after.scene()), task).termination, Termination::done);
  EXPECT_EQ(method.prepared, 2);
  EXPECT_EQ(method.lit, 2);
}

TEST_F(Session, ACancelledRunSaysSo) {
  TaskSettings settings;
  settings.cancel = std::make_shared<std::atomic<bool>>(true);
  Task cancelled(settings);
  EXPECT_EQ(session.prepare(world, {}, cancelled).termination, Termination::cancelled);
}

/// The shared evaluator completes a method that gives indirect light only.
TEST_F(Session, DirectLightIsCompletedByTheSharedEvaluator) {
  method.can.direct = false;
  make_ready();
  bool asked_for_direct = true;
  method.shading = [&](const ShadeAnswer& answer) { asked_for_direct = !answer.direct.empty(); };
  EXPECT_EQ(shade().termination, Termination::done);
  EXPECT_FALSE(asked_for_direct);
  const DirectLight expected(world, lighting);
  double sum = 0.0, reference = 0.0;
  RayStream rays = task.rays(world);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    sum += static_cast<double>(luminance(direct[i]));
    reference += static_cast<double>(luminance(expected.irradiance(samples[i], 99 + i, 256, rays)));
  }
  EXPECT_NEAR(sum, reference, 0.2 * reference);
  EXPECT_GT(reference, 0.0);
}

/// B = π Le + ρ E on every material of the box.
TEST_F(Session, RadiosityIsDerivedFromIrradiance) {
  make_ready();
  std::vector<Rgb> irradiance(samples.size()), indirect_irradiance(samples.size());
  session.shade({Quantity::irradiance, samples, {}}, {irradiance, indirect_irradiance, {}, {}, {}}, task);
  EXPECT_EQ(shade(Quantity::radiosity).termination, Termination::done);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Material& material = world.scene().material_of_object(samples[i].object);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_FLOAT_EQ(direct[i][channel], pi * material.emission[channel] + material.diffuse[channel] * irradiance[i][channel]);
      EXPECT_FLOAT_EQ(indirect[i][channel], material.diffuse[channel] * indirect_irradiance[i][channel]);
    }
  }
}

/// L = Le + ρ E / π on every material of the box, from a method that answers irradiance alone.
TEST_F(Session, RadianceIsDerivedFromIrradiance) {
  method.can.quantities = {Quantity::irradiance};
  make_ready();
  std::vector<Rgb> irradiance(samples.size()), indirect_irradiance(samples.size());
  session.shade({Quantity::irradiance, samples, {}}, {irradiance, indirect_irradiance, {}, {}, {}}, task);
  EXPECT_EQ(shade(Quantity::radiance).termination, Termination::done);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Material& material = world.scene().material_of_object(samples[i].object);
    for (int channel = 0; channel < 3; ++channel) {
      const float reflected = material.diffuse[channel] / pi;
      EXPECT_FLOAT_EQ(direct[i][channel], material.emission[channel] + reflected * irradiance[i][channel]);
      EXPECT_FLOAT_EQ(indirect[i][channel], reflected * indirect_irradiance[i][channel]);
    }
  }
}

TEST_F(Session, KnowsWhatCanBeAsked) {
  EXPECT_TRUE(session.answers(Quantity::irradiance) && session.answers(Quantity::radiance));
  EXPECT_TRUE(session.answers(Quantity::radiosity)) << "it follows from irradiance";
  EXPECT_FALSE(session.answers(Quantity::accessibility));
  EXPECT_TRUE(session.knows_variance(Quantity::radiance));
  EXPECT_FALSE(session.knows_variance(Quantity::radiosity)) << "a derived quantity has none";
  method.can.quantities = {Quantity::radiance};
  EXPECT_FALSE(session.answers(Quantity::irradiance) || session.answers(Quantity::radiosity));
}

/// A room without light, planned as such, and then lit.
class LightsThatComeOn : public Session {
 protected:
  LightsThatComeOn() : dark(dark_room(), 1), lights(Lighting::of(dark.scene())) {
    lights.lights.emplace_back(PointLight{{0.5F, 0.5F, 0.5F}, Rgb(1.0F)});
    plan = plan_effects(analyse_effects(dark), effects_of(method.can));
  }
  static Scene dark_room() {
    made::BoxOptions options;
    options.lamp_emission = Rgb();
    return made::box_scene(options);
  }

  World dark;
  Lighting lights;
  EffectPlan plan;
};

TEST_F(LightsThatComeOn, PrepareTheMethodForWhatTheyCallFor) {
  ASSERT_TRUE(succeeded(session.prepare(dark, plan, task).termination));
  EXPECT_FALSE(method.prepared_for.contains(Effect::diffuse_indirect));
  EXPECT_EQ(session.light(Lighting::of(dark.scene()), task).message, "no light: nothing to transport");
  EXPECT_TRUE(succeeded(session.light(lights, task).termination));
  EXPECT_EQ(method.prepared, 2);
  EXPECT_EQ(method.lit, 1);
  EXPECT_TRUE(method.prepared_for.contains(Effect::diffuse_indirect));
  session.light(lights, task);
  EXPECT_EQ(method.prepared, 2) << "the plan holds now";
}

using LightsThatComeOnDeathTest = LightsThatComeOn;

TEST_F(LightsThatComeOnDeathTest, LeaveNothingToBuildOnWherePreparingFails) {
  ASSERT_TRUE(succeeded(session.prepare(dark, plan, task).termination));
  method.prepare_ends = Termination::out_of_budget;
  EXPECT_EQ(session.light(lights, task).termination, Termination::out_of_budget);
  EXPECT_EQ(method.lit, 0);
  EXPECT_THAT([&] { session.light(lights, task); }, test::fails_check("after a prepare"));
}

}  // namespace
}  // namespace gibench
