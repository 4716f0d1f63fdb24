#include "methods/antiradiance/accessibility.h"

#include "common/core/random.h"
#include "methods/antiradiance/discretisation.h"
#include "methods/antiradiance/sky_as_ambient.h"
#include "methods/antiradiance/strategy.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t shade_chunk = 64;  // samples

/// Answers accessibility, and direct light in which it dims the environments; no indirect light.
class AccessibilityStrategy : public Strategy {
 public:
  using Strategy::Strategy;

  Capabilities capabilities() const override {
    Capabilities can;
    can.effects = {Effect::direct, Effect::environment, Effect::occlusion};
    can.quantities = {Quantity::irradiance, Quantity::radiance, Quantity::accessibility};
    can.relights = true;
    can.indirect = false;
    return can;
  }

  void prepare(const World& world, const EffectPlan&, Task& task, StageReport& report) override {
    accessibility_.reset();
    parts_.reset();
    // Two tables of two nodes an element, and the leaves of a third.
    const double table_bytes = 5.0 * sizeof(float) * settings().sectors * settings().sectors;
    parts_ = make_elements(world, settings(), table_bytes, task, report);
    if (!parts_ || task.cancelled()) return;
    accessibility_.emplace(parts_->elements, parts_->hierarchy, settings().far_enough, settings().sectors);
    accessibility_->compute(settings().passes, task);
    task.count("blockers", accessibility_->evaluations());
  }

  void light(const World& world, const EffectPlan& plan, const PlannedLights& lights, Task&, StageReport&) override {
    DirectLightOptions options;
    options.tests_visibility = lights.direct.options().tests_visibility;
    options.glossy = !plan.forbids(Effect::glossy_final_bounce);
    sky_.emplace(world, lights.lighting, options, accessibility_->sectors());
  }

  void shade(const World& world, const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const override {
    task.parallel_chunks(request.samples.size(), shade_chunk, [&](const ChunkRange& range) {
      RayStream rays = task.rays(world);
      for (std::size_t i = range.begin; i < range.end; ++i) {
        const SurfaceSample& sample = request.samples[i];
        const Vec3* viewer = request.quantity == Quantity::radiance ? &request.toward_viewer[i] : nullptr;
        if (!answer.direct.empty())
          answer.direct[i] =
              request.quantity == Quantity::accessibility
                  ? Rgb(accessibility_->at(world.ray_origin(sample), sample.normal))
                  : sky_->answer(sample, viewer, mix_keys(task.seed(), i), request.samples.size(), *accessibility_, rays);
        if (!answer.indirect.empty()) answer.indirect[i] = Rgb();
      }
    });
  }

  std::size_t bytes() const override { return (parts_ ? parts_->bytes() : 0) + (accessibility_ ? accessibility_->bytes() : 0); }

 private:
  std::unique_ptr<Discretisation> parts_;
  std::optional<Accessibility> accessibility_;
  std::optional<SkyAsAmbient> sky_;
};

}  // namespace

std::unique_ptr<Strategy> accessibility_strategy(const Settings& settings) {
  return std::make_unique<AccessibilityStrategy>(settings);
}

}  // namespace gibench::antiradiance
