/// What a scene calls for, with the evidence, and the plan that follows for a method.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common/effects/effect_plan.h"
#include "common/ray/world.h"

namespace gibench {

/// One effect and what in the scene decides about it.
struct EffectEvidence {
  Effect effect;
  bool called_for = false;
  std::string why;  ///< the evidence, one line: "1 emitting material ('lamp')", "every diffuse albedo is 0"
};

/// Every effect once, in the order of all_effects().
struct SceneEffects {
  std::vector<EffectEvidence> effects;
  std::optional<int> max_bounces;  ///< reflections between a light and the surface asked about; empty: no bound

  const EffectEvidence& operator[](Effect effect) const;
  EffectSet called_for() const;
};

/// How surfaces lie to one another, as far as visibility goes.
enum class Arrangement {
  general,          ///< surfaces may hide one another
  convex_room,      ///< every front looks into one convex space: all fronts see one another
  no_mutual_sight,  ///< every surface lies behind (or in the plane of) every other: a convex body, a flat plate
};
/// Exact up to 1e-5 of the scene's diagonal; degenerate triangles do not count. `general` for more than 4096 triangles,
/// where looking at every pair would cost more than it saves.
Arrangement arrangement_of(const World& world);

/// Looks at lights, materials in use and geometry. `bounces` is the user's bound on reflections between a light and
/// the surface asked about. Never leaves out an effect that the scene needs: what is not certain is called for.
SceneEffects analyse_effects(const World& world, std::optional<int> bounces = std::nullopt);

/// called for ∩ what the method can do; the rest is missing (called for, beyond the method) or skipped with its reason.
EffectPlan plan_effects(const SceneEffects& scene, const EffectSet& can_do);

}  // namespace gibench
