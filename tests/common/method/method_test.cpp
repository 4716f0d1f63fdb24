/// The checks that the public calls make, on a method that does what each test tells it to.
#include "common/method/method.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <vector>

#include "common/geometry/surface_sampling.h"
#include "tests/support/check_failed.h"
#include "tests/support/scene_builder.h"

namespace gibench {
namespace {

/// Answers 1 + index everywhere unless told otherwise.
class ScriptedMethod : public TransportMethod {
 public:
  Capabilities can{
      {Effect::direct, Effect::diffuse_indirect}, {Quantity::radiance, Quantity::irradiance}, true, true, true, false};
  Termination prepare_ends = Termination::done, light_ends = Termination::done;
  std::function<void(const ShadeAnswer&)> shading = [](const ShadeAnswer&) {};
  int prepared = 0, lit = 0;

  Capabilities capabilities() const noexcept override { return can; }

 private:
  void do_prepare(Task& task, StageReport& report) override {
    ++prepared;
    task.count("nodes", 3);
    task.progress("nodes", 1.0);
    report.termination = prepare_ends;
  }
  void do_light(const Lighting&, Task&, StageReport& report) override {
    ++lit;
    report.termination = light_ends;
  }
  void do_shade(const ShadeRequest&, const ShadeAnswer& answer, Task&, StageReport&) const override {
    for (std::span<Rgb> values : {answer.direct, answer.indirect, answer.direct_variance, answer.indirect_variance})
      for (std::size_t i = 0; i < values.size(); ++i) values[i] = Rgb(static_cast<float>(1 + i));
    shading(answer);
  }
};

class Method : public testing::Test {
 protected:
  Method() : world(test::box_scene(), 1), lighting(Lighting::of(world.scene())) {
    samples = area_uniform_samples(world, 10, 1);
    for (const SurfaceSample& sample : samples) normals.push_back(sample.normal);
    direct.resize(samples.size());
    indirect.resize(samples.size());
  }
  void make_ready() {
    ASSERT_TRUE(succeeded(method.prepare(world, {}, task).termination));
    ASSERT_TRUE(succeeded(method.light(lighting, task).termination));
  }
  StageReport shade(Quantity quantity = Quantity::irradiance) {
    const bool viewed = quantity == Quantity::radiance;
    return method.shade({quantity, samples, viewed ? std::span<const Vec3>(normals) : std::span<const Vec3>()},
                        {direct, indirect, {}, {}, {}}, task);
  }

  World world;
  Lighting lighting;
  ScriptedMethod method;
  Task task;
  std::vector<SurfaceSample> samples;
  std::vector<Vec3> normals;
  std::vector<Rgb> direct, indirect;
};

TEST_F(Method, ThePublicCallsComeInOrder) {
  EXPECT_THAT([&] { method.light(lighting, task); }, test::fails_check("after a prepare"));
  EXPECT_THAT([&] { shade(); }, test::fails_check("after a light"));
  method.prepare(world, {}, task);
  EXPECT_THAT([&] { shade(); }, test::fails_check("after a light"));
  EXPECT_THAT([&] { method.light(Lighting{}, task); }, test::fails_check("one emission for each material"));
}

TEST_F(Method, AStageThatFailedCannotBeBuiltOn) {
  method.prepare_ends = Termination::out_of_budget;
  EXPECT_EQ(method.prepare(world, {}, task).termination, Termination::out_of_budget);
  EXPECT_THAT([&] { method.light(lighting, task); }, test::fails_check("after a prepare"));
  method.prepare_ends = Termination::done;
  method.light_ends = Termination::not_converged;
  method.prepare(world, {}, task);
  EXPECT_EQ(method.light(lighting, task).termination, Termination::not_converged);
  EXPECT_THAT([&] { shade(); }, test::fails_check("after a light"));
}

TEST_F(Method, SizesAndQuantitiesAreChecked) {
  make_ready();
  std::vector<Rgb> few(samples.size() - 1);
  EXPECT_THAT(
      [&] {
        method.shade({Quantity::irradiance, samples, {}}, {few, {}, {}, {}, {}}, task);
      },
      test::fails_check("one value for each sample"));
  EXPECT_THAT(
      [&] {
        method.shade({Quantity::irradiance, samples, {}}, {{}, {}, few, {}, {}}, task);
      },
      test::fails_check("one variance for each"));
  EXPECT_THAT(
      [&] {
        method.shade({Quantity::radiance, samples, {}}, {direct, {}, {}, {}, {}}, task);
      },
      test::fails_check("one direction for each"));
  EXPECT_THAT([&] { shade(Quantity::accessibility); }, test::fails_check("only for quantities that it answers"));
  method.can.variance = false;
  EXPECT_THAT(
      [&] {
        method.shade({Quantity::irradiance, samples, {}}, {direct, {}, indirect, {}, {}}, task);
      },
      test::fails_check("methods that know it"));
}

TEST_F(Method, EveryValueThatWasWrittenIsHandedOn) {
  make_ready();
  EXPECT_EQ(shade().termination, Termination::done);
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(direct[i], Rgb(static_cast<float>(1 + i)));
}

TEST_F(Method, AValueThatWasNotWrittenIsTold) {
  make_ready();
  method.shading = [](const ShadeAnswer& answer) { answer.indirect[4] = Rgb(std::numeric_limits<float>::quiet_NaN()); };
  const StageReport report = shade();
  EXPECT_EQ(report.termination, Termination::invalid_output);
  EXPECT_EQ(report.message, "indirect light of sample 4 was not written or is not finite");
}

TEST_F(Method, AnswersArePoisonedBeforeTheWork) {
  make_ready();
  direct.assign(samples.size(), Rgb(7.0F));
  bool poisoned = true;
  method.shading = [&](const ShadeAnswer& answer) { poisoned = std::isnan(answer.total_variance[0].r); };
  std::vector<Rgb> total_variance(samples.size());
  const StageReport report = method.shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, total_variance}, task);
  EXPECT_TRUE(poisoned) << "the method saw what the caller had left";
  EXPECT_EQ(report.termination, Termination::invalid_output) << "nobody wrote the total variance";
}

TEST_F(Method, AnInfiniteValueIsTold) {
  make_ready();
  method.shading = [](const ShadeAnswer& answer) { answer.direct[0].g = INFINITY; };
  EXPECT_EQ(shade().termination, Termination::invalid_output);
}

TEST_F(Method, StagesReportTheirOwnCountsAndHistory) {
  const StageReport first = method.prepare(world, {}, task), second = method.prepare(world, {}, task);
  EXPECT_EQ(first.counters["nodes"], 3U);
  EXPECT_EQ(second.counters["nodes"], 3U);
  EXPECT_EQ(second.history.size(), 1U);
  EXPECT_GE(second.seconds, 0.0);
  EXPECT_EQ(task.counters()["nodes"], 6U);
}

TEST_F(Method, RelightingDoesNotPrepareAgain) {
  make_ready();
  method.light(lighting, task);
  EXPECT_EQ(method.prepared, 1);
  EXPECT_EQ(method.lit, 2);
}

TEST_F(Method, AnEditPreparesAndLightsAgainByDefault) {
  make_ready();
  test::BoxOptions options;
  options.blocks = false;
  const World after(test::box_scene(options), 1);
  const SceneEdit edit = MoveEdit{"tall", {0, 0, 0}, {0, 0, 0}};
  EXPECT_EQ(method.edit(edit, after, Lighting::of(after.scene()), task).termination, Termination::done);
  EXPECT_EQ(method.prepared, 2);
  EXPECT_EQ(method.lit, 2);
}

TEST_F(Method, ACancelledRunSaysSo) {
  TaskSettings settings;
  settings.cancel = std::make_shared<std::atomic<bool>>(true);
  Task cancelled(settings);
  EXPECT_EQ(method.prepare(world, {}, cancelled).termination, Termination::cancelled);
}

/// Where a method gives indirect light alone, the shared evaluator completes it.
TEST_F(Method, DirectLightIsCompletedByTheSharedEvaluator) {
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
TEST_F(Method, RadiosityIsDerivedFromIrradiance) {
  make_ready();
  std::vector<Rgb> irradiance(samples.size()), indirect_irradiance(samples.size());
  method.shade({Quantity::irradiance, samples, {}}, {irradiance, indirect_irradiance, {}, {}, {}}, task);
  EXPECT_EQ(shade(Quantity::radiosity).termination, Termination::done);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    const Material& material = world.scene().material_of_object(samples[i].object);
    for (int channel = 0; channel < 3; ++channel) {
      EXPECT_FLOAT_EQ(direct[i][channel], pi * material.emission[channel] + material.diffuse[channel] * irradiance[i][channel]);
      EXPECT_FLOAT_EQ(indirect[i][channel], material.diffuse[channel] * indirect_irradiance[i][channel]);
    }
  }
}

}  // namespace
}  // namespace gibench
