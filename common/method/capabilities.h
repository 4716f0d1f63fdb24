/// The capabilities of a method, as flags: callers never ask for its name.
#pragma once

#include <set>

#include "common/effects/effect_plan.h"
#include "common/method/quantity.h"

namespace gibench {

/// What a method can simulate, answer and do again cheaply.
struct Capabilities {
  EffectSet effects;
  std::set<Quantity> quantities;  ///< what shade() answers; the session derives others from irradiance, see MethodSession
  bool direct = true;             ///< computes direct light itself; else the shared evaluator completes it
  bool indirect = true;
  bool variance = false;         ///< knows the variance of its answers
  bool relights = false;         ///< light() again without prepare() costs less than both
  bool any_light_paths = false;  ///< obeys EffectPlan::light_paths
};

/// The effects of a method's answers: its own, and direct light where the shared evaluator completes it.
EffectSet effects_of(const Capabilities& can);

}  // namespace gibench
