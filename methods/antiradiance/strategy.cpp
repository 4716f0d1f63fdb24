#include "methods/antiradiance/strategy.h"

namespace gibench::antiradiance {

std::unique_ptr<Strategy> make_strategy(const Settings& settings) {
  switch (settings.mode) {
    case Mode::accessibility: return accessibility_strategy(settings);
    case Mode::disc_bounce: return disc_bounce_strategy(settings);
    case Mode::radiosity: return radiosity_strategy(settings);
    case Mode::implicit: return implicit_strategy(settings);
    case Mode::antiradiance: break;
  }
  return antiradiance_strategy(settings);
}

}  // namespace gibench::antiradiance
