#include "methods/antiradiance/linked_strategy.h"

namespace gibench::antiradiance {

namespace {

/// Of the links of each directional bin the nearest carries light.
class ImplicitStrategy : public LinkedStrategy {
 public:
  using LinkedStrategy::LinkedStrategy;

 private:
  Visibility visibility(const EffectPlan&, bool hides) const override {
    return hides ? Visibility::nearest : Visibility::none_needed;
  }
};

}  // namespace

std::unique_ptr<Strategy> implicit_strategy(const Settings& settings) { return std::make_unique<ImplicitStrategy>(settings); }

}  // namespace gibench::antiradiance
