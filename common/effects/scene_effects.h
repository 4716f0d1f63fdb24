/// The effects that a scene calls for, with the evidence, and the plan that follows for a method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/effects/bounce_bound.h"
#include "common/effects/effect_plan.h"
#include "common/effects/scene_facts.h"
#include "common/ray/world.h"

namespace gibench {

/// One effect and what in the scene decides about it.
struct EffectEvidence {
  Effect effect;
  bool called_for = false;
  std::string why;  ///< the evidence, one line: "1 emitting material ('lamp')", "every diffuse albedo is 0"
};

/// Share of the light for which a scene's bounce bound is shown if none is asked for.
inline constexpr double usual_tolerance = 1e-3;

/// Every effect once, in the order of all_effects().
struct SceneEffects {
  std::vector<EffectEvidence> effects;
  std::optional<int> max_bounces;  ///< reflections between a light and the surface asked about; empty: no bound
  BounceBound bound;               ///< at the tolerance asked for, or the usual one; binds only in the first case
  LightCounts lights;              ///< those that reach a surface
  Arrangement arrangement = Arrangement::general;
  bool sealed = false, unlit = false, grey_surfaces = false;
  std::set<Change> changes;
  PathEvents events;  ///< of which its light paths are made
  PlanLimits limits;

  const EffectEvidence& operator[](Effect effect) const;
  EffectSet called_for() const;
};

/// Looks at lights, materials in use, geometry and edits. Never leaves out an effect that the scene needs: what is not
/// certain is called for. Costs milliseconds: geometry beyond a few thousand triangles is taken as general.
SceneEffects analyse_effects(const World& world, const PlanLimits& limits);
/// The same under other lights than the scene's own.
SceneEffects analyse_effects(const World& world, const Lighting& lighting, const PlanLimits& limits);
/// With a bound on the reflections between a light and the surface asked about alone.
SceneEffects analyse_effects(const World& world, std::optional<int> bounces = std::nullopt);

/// called for ∩ what the method can do ∩ what the user allows; the rest is missing (called for, beyond the
/// method) or skipped with its reason. Every method must handle two-sided surfaces and colour: one that cannot
/// refuses the scene.
EffectPlan plan_effects(const SceneEffects& scene, const EffectSet& can_do);

}  // namespace gibench
