/// Runs of methods that answer a single quantity.
#include <gmock/gmock.h>

#include <memory>

#include "bench/measure/run_method.h"
#include "common/core/error.h"
#include "common/scene/made_scenes.h"

namespace gibench {
namespace {

/// The same light everywhere, as one quantity.
template <Quantity quantity>
class OneQuantity : public TransportMethod {
 public:
  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::diffuse_indirect, Effect::occlusion};
    can.quantities = {quantity};
    can.variance = true;
    return can;
  }
  void prepare(const World&, const EffectPlan&, Task&, StageReport&) override {}
  void light(const PlannedLights&, Task&, StageReport&) override {}
  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task&, StageReport& report) const override {
    if (request.quantity != quantity) report.termination = Termination::not_converged;
    for (std::span<Rgb> values : {answer.direct, answer.indirect, answer.total_variance})
      for (Rgb& value : values) value = Rgb(1.0F);
  }
};

template <Quantity quantity>
MethodEntry entry_of() {
  return {"single",
          "one quantity",
          "a double",
          "C(<RD>)*[LO]",
          {},
          [](const Parameters&) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<OneQuantity<quantity>>(); }};
}

RunOutcome run_in_a_box(const MethodEntry& entry) {
  const LoadedScene scene{std::make_unique<World>(made::box_scene(), 1)};
  MeasuringOptions measuring;
  measuring.surface_samples = 16;
  measuring.pixel_samples = 1;
  WorkOptions common;
  common.threads = 1;
  common.quiet = true;
  RunLog log({}, true);
  return run_method(scene, {&entry, Parameters(entry.schema, {})}, measuring, {}, common, log);
}

TEST(ARun, TakesAMethodThatAnswersIrradianceAlone) {
  const RunOutcome outcome = run_in_a_box(entry_of<Quantity::irradiance>());
  EXPECT_EQ(outcome.surface.indirect.front(), Rgb(1.0F));
  EXPECT_EQ(outcome.surface.total_variance.size(), 16U);
  ASSERT_TRUE(outcome.image);
  EXPECT_TRUE(succeeded(outcome.image->report.termination));
  EXPECT_TRUE(outcome.image->total_variance.empty()) << "radiance is derived, its variance not known";
}

TEST(ARun, RefusesAMethodThatAnswersNoIrradiance) {
  try {
    run_in_a_box(entry_of<Quantity::radiance>());
    FAIL() << "it was taken";
  } catch (const WorkError& refused) {
    EXPECT_STREQ(refused.what(), "refused: single does not answer irradiance, in which methods are compared at surface samples");
  }
}

}  // namespace
}  // namespace gibench
