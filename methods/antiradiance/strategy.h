/// One mode of the method: its treatment of a scene, of the lights, and of the points asked about.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "common/method/method.h"
#include "methods/antiradiance/settings.h"

namespace gibench::antiradiance {

/// The stages are those of TransportMethod, with what they need as arguments. The world outlives the strategy's use of it.
class Strategy {
 public:
  explicit Strategy(const Settings& settings) : settings_(settings) {}
  virtual ~Strategy() = default;

  virtual Capabilities capabilities() const = 0;
  virtual std::optional<std::string> refusal(const Scene&) const { return std::nullopt; }
  virtual void prepare(const World& world, const EffectPlan& plan, Task& task, StageReport& report) = 0;
  virtual void light(const World& world, const EffectPlan& plan, const PlannedLights& lights, Task& task,
                     StageReport& report) = 0;
  virtual void shade(const World& world, const ShadeRequest& request, const ShadeAnswer& answer, Task& task) const = 0;
  virtual std::size_t bytes() const = 0;

 protected:
  const Settings& settings() const { return settings_; }

 private:
  Settings settings_;
};

std::unique_ptr<Strategy> accessibility_strategy(const Settings& settings);
std::unique_ptr<Strategy> disc_bounce_strategy(const Settings& settings);
std::unique_ptr<Strategy> radiosity_strategy(const Settings& settings);
std::unique_ptr<Strategy> implicit_strategy(const Settings& settings);
std::unique_ptr<Strategy> antiradiance_strategy(const Settings& settings);

/// That of settings.mode.
std::unique_ptr<Strategy> make_strategy(const Settings& settings);

}  // namespace gibench::antiradiance
