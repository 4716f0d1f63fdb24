#include "methods/antiradiance/antiradiance.h"

#include <memory>
#include <vector>

#include "common/geometry/has_area.h"
#include "methods/antiradiance/settings.h"
#include "methods/antiradiance/strategy.h"

namespace gibench {

namespace {

using namespace antiradiance;

class Antiradiance : public TransportMethod {
 public:
  explicit Antiradiance(const Settings& settings)
      : strategy_(make_strategy(settings)), capabilities_(strategy_->capabilities()) {}

  Capabilities capabilities() const noexcept override { return capabilities_; }

  std::optional<std::string> refusal(const Scene& scene) const override {
    if (auto why = strategy_->refusal(scene)) return why;
    if (has_area(scene)) return std::nullopt;
    return "every face of the scene has zero area: there is nowhere to put elements";
  }

  std::size_t bytes() const override { return strategy_->bytes(); }

  void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) override {
    world_ = &world;
    plan_ = plan;
    strategy_->prepare(world, plan, task, report);
  }

  void light(const PlannedLights& lights, Task& task, StageReport& report) override {
    strategy_->light(*world_, plan_, lights, task, report);
  }

  void shade(const ShadeRequest& request, const ShadeAnswer& answer, Task& task, StageReport&) const override {
    strategy_->shade(*world_, request, answer, task);
  }

 private:
  std::unique_ptr<Strategy> strategy_;
  Capabilities capabilities_;
  const World* world_ = nullptr;
  EffectPlan plan_;
};

std::vector<Preset> presets() {
  return {
      {"paper",
       "the text's own algorithm in every mode: a disc for every vertex, form factors of discs, no rays but for visibility in "
       "mode=radiosity and direct light",
       {{"merge", "false"},
        {"crease_degrees", "180"},
        {"backface_rays", "0"},
        {"closure_rays", "0"},
        {"split_partial", "false"},
        {"near_field", "discs"},
        {"bin_winner", "links"},
        {"passes", "2"},
        {"sectors", "1"}}}};
}

}  // namespace

MethodEntry antiradiance_entry() {
  return {"antiradiance",
          "disc elements: accessibility, one disc bounce, and hierarchical radiosity with traced, implicit or no visibility",
          "course notes on finite elements at interactive rates, after Bunnell 2005, Dong et al. 2007, Dachsbacher et al. 2007, "
          "Meyer et al. 2009",
          "C(<R[DG]>)*[LOB]",
          settings_schema(),
          [](const Parameters& parameters) -> std::unique_ptr<TransportMethod> {
            return std::make_unique<Antiradiance>(settings_from(parameters));
          },
          {{"elements", "800"}, {"bins", "8"}, {"tolerance", "0.03"}, {"residual", "1e-5"}, {"far_enough", "0.05"}},
          "mode",
          presets()};
}

}  // namespace gibench
