/// The effects that a scene calls for, the bound on its bounces and the plans of methods, as records write and read them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/effects/effect_plan.h"
#include "common/effects/scene_effects.h"

namespace gibench {

/// {called_for, simulated, missing, skipped: [{effect, why}]}
nlohmann::ordered_json to_json(const EffectPlan& plan);
EffectPlan effect_plan_of(const nlohmann::ordered_json& json);

/// [{effect, called_for, evidence}]
nlohmann::ordered_json to_json(const std::vector<EffectEvidence>& effects);
std::vector<EffectEvidence> evidence_of(const nlohmann::ordered_json& json);

/// How many reflections a scene's light needs.
struct BoundRecord {
  double tolerance = 0.0;   ///< share of the light that the reflections beyond may hold
  std::optional<int> most;  ///< empty: not bounded
  bool binds = false;       ///< whether plans leave out what is beyond
  std::string evidence;

  /// At the tolerance that was asked for, or at the usual one, at which nothing is left out.
  static BoundRecord of(const SceneEffects& effects);
};
nlohmann::ordered_json to_json(const BoundRecord& bound);
BoundRecord bound_record_of(const nlohmann::ordered_json& json);

}  // namespace gibench
