#include <fmt/format.h>

#include "methods/antiradiance/linked_strategy.h"
#include "methods/antiradiance/patch_transport.h"

namespace gibench::antiradiance {

namespace {

/// Bunnell's single bounce: a pass in which radiosities are sent without visibility, then passes that take off the shadow of
/// what every element received in the one before, cast from its back; the last two of all `passes` are averaged.
class DiscBounceStrategy : public LinkedStrategy {
 public:
  using LinkedStrategy::LinkedStrategy;

 private:
  Visibility visibility(const EffectPlan&, bool /*hides*/) const override { return Visibility::shadow_passes; }

  Interreflection solve(const World&, const EffectPlan&, const PlannedLights&, std::span<const std::uint32_t> /*materials*/,
                        Surfaces& surfaces, std::span<const Rgb> direct, Task& task) override {
    const PatchTransport transport(parts().hierarchy, linking().links);
    const std::vector<Rgb> fronts = products(direct, surfaces.albedo);
    std::vector<Rgb> received(direct.size()), before, backs;
    transport.transport(fronts, {}, received, task);
    Interreflection result;
    for (int pass = 1; pass < settings().passes && !task.cancelled(); ++pass) {
      before = received;
      backs.clear();
      for (const Rgb& light : received) backs.push_back(light * -1.0F);
      transport.transport(fronts, backs, received, task);
      ++result.iterations;
      task.progress("shadow pass", static_cast<double>(pass) / settings().passes);
    }
    for (std::size_t i = 0; i < received.size() && !before.empty(); ++i) received[i] = (received[i] + before[i]) * 0.5F;
    result.termination = Termination::bound_reached;
    result.message = fmt::format("one bounce with {} shadow passes", settings().passes - 1);
    result.irradiance = std::move(received);
    return result;
  }
};

}  // namespace

std::unique_ptr<Strategy> disc_bounce_strategy(const Settings& settings) {
  return std::make_unique<DiscBounceStrategy>(settings);
}

}  // namespace gibench::antiradiance
