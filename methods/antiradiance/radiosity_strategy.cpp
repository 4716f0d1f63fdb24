#include "methods/antiradiance/linked_strategy.h"

namespace gibench::antiradiance {

namespace {

/// Rays measure, link by link, how much of its light arrives.
class RadiosityStrategy : public LinkedStrategy {
 public:
  using LinkedStrategy::LinkedStrategy;

 private:
  Visibility visibility(const EffectPlan&, bool hides) const override {
    return hides ? Visibility::traced : Visibility::none_needed;
  }
};

}  // namespace

std::unique_ptr<Strategy> radiosity_strategy(const Settings& settings) { return std::make_unique<RadiosityStrategy>(settings); }

}  // namespace gibench::antiradiance
