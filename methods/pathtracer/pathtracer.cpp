#include "methods/pathtracer/pathtracer.h"

#include <memory>

#include "common/effects/scene_facts.h"
#include "methods/pathtracer/path_rules.h"
#include "methods/pathtracer/shade_job.h"

namespace gibench {

namespace pathtracer {

namespace {

class PathTracer final : public TransportMethod {
 public:
  explicit PathTracer(const Settings& settings) : settings_(settings) {}

  Capabilities capabilities() const noexcept override {
    Capabilities can;
    can.effects = {all_effects().begin(), all_effects().end()};
    can.quantities = {Quantity::radiance, Quantity::irradiance, Quantity::radiosity, Quantity::accessibility};
    can.variance = settings_.replicates >= 2 && settings_.samples >= 2;
    can.relights = true;
    can.any_light_paths = true;
    return can;
  }
  std::size_t bytes() const override { return (scene_ ? scene_->bytes() : 0) + (lights_ ? lights_->bytes() : 0); }

  std::string light_paths(const EffectPlan& plan, const BounceRange& range) const override {
    return plan.light_paths.empty() ? light_paths_of(plan, false, range) : plan.light_paths;
  }

  void prepare(const World& world, const EffectPlan& plan, Task&, StageReport&) override {
    world_ = &world;
    plan_ = plan;
    scene_ = std::make_unique<PathScene>(world);
  }
  void light(const PlannedLights& lights, Task&, StageReport& report) override {
    lights_ = std::make_unique<SceneLights>(*world_, lights.lighting);
    const PathEvents events = SceneFacts(*world_, lights.lighting).events;
    rules_ = std::make_unique<PathRules>(PathAutomaton(light_paths(plan_, {})).restricted_to(events),
                                         lights.direct.options().tests_visibility);
    if (rules_->nothing() && !lights_->empty()) report.message = "no light path of the scene is among those to simulate";
  }
  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    if (request.samples.empty()) return;
    ShadeJob(*scene_, *lights_, *rules_, settings_, plan_, request, answer, task).run();
  }

 private:
  Settings settings_;
  const World* world_ = nullptr;
  EffectPlan plan_;
  std::unique_ptr<PathScene> scene_;
  std::unique_ptr<SceneLights> lights_;
  std::unique_ptr<PathRules> rules_;
};

}  // namespace

}  // namespace pathtracer

MethodEntry pathtracer_entry() {
  MethodEntry entry;
  entry.name = "pathtracer";
  entry.summary = "path tracing with next-event estimation and multiple importance sampling; unbiased: the reference";
  entry.source = "Kajiya 1986, The Rendering Equation; Veach 1997, Robust Monte Carlo Methods for Light Transport Simulation";
  entry.light_paths = "C.*[LOB]";
  entry.schema = pathtracer::settings_schema();
  entry.make = [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
    return std::make_unique<pathtracer::PathTracer>(pathtracer::settings_from(parameters));
  };
  return entry;
}

}  // namespace gibench
