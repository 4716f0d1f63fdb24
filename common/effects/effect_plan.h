/// The effects that a scene may call for, and the plan that a method works under.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "common/effects/arrangement.h"
#include "common/effects/changes.h"

namespace gibench {

/// A class of light paths, or a property of the scene that costs work.
enum class Effect {
  direct,               ///< light straight from a light
  diffuse_indirect,     ///< diffuse interreflection: every surface before the one asked about scatters diffusely
  glossy_final_bounce,  ///< a glossy surface that a camera or a query sees
  glossy_chain,         ///< glossy surfaces that light other surfaces: caustics
  environment,          ///< light from an environment
  occlusion,            ///< surfaces that hide one another
  two_sided,            ///< surfaces that reflect on both sides
  colour,               ///< channels that differ
};
using EffectSet = std::set<Effect>;

const char* to_string(Effect effect);
/// One line for people.
const char* meaning_of(Effect effect);
const std::vector<Effect>& all_effects();
/// Properties of a scene, not classes of its paths: a user's choice of effects says nothing about them.
const EffectSet& scene_properties();
/// Effects by their names. Throws InputError at `place`, the known ones listed, for an unknown name.
EffectSet effects_of_names(const std::vector<std::string>& names, const std::string& place);
/// "direct, occlusion"
std::string names_of(const EffectSet& effects);

/// What the user asks for.
struct PlanLimits {
  std::optional<EffectSet> allowed;  ///< classes of paths that may be simulated; empty: all
  std::optional<int> bounces;        ///< reflections between a light and the surface asked about, at most; empty: all
  double tolerance = 0.0;            ///< share of the light that left-out bounces may hold; 0: none is left out
  EffectSet forced;                  ///< simulated even where the scene does not call for it
};

/// An effect that a method does not simulate on a scene, and the reason.
struct SkippedEffect {
  Effect effect;
  std::string why;
};

/// called for by the scene ∩ what the method can do ∩ what the user allows, the bounce bound, and the reason for each
/// thing skipped.
struct EffectPlan {
  EffectSet called_for;
  EffectSet simulated;                 ///< what prepare(), light() and shade() are to compute
  EffectSet missing;                   ///< called for, but beyond the method
  std::vector<SkippedEffect> skipped;  ///< not called for, or not allowed: not computed
  std::optional<int> max_bounces;      ///< reflections between a light and the surface asked about; empty: no bound

  // Further results of the analysis; the defaults claim nothing.
  Arrangement arrangement = Arrangement::general;
  bool sealed = false;         ///< nothing from outside, an environment or a directional light, reaches a surface
  bool unlit = false;          ///< the scene has no light
  bool grey_surfaces = false;  ///< every surface treats all channels alike
  std::set<Change> changes;    ///< what the scene's edits change
  std::string light_paths;     ///< only these paths, as an expression; empty: whatever else the plan says

  std::optional<PlanLimits> limits;  ///< from which it was made; empty for a plan made by hand

  bool simulates(Effect effect) const { return simulated.contains(effect); }
  /// Called for, and yet not to be computed: missing or not allowed.
  bool leaves_out(Effect effect) const { return called_for.contains(effect) && !simulated.contains(effect); }
  /// Not allowed by the user.
  bool forbids(Effect effect) const { return leaves_out(effect) && !missing.contains(effect); }
  /// The analysis says that no light comes by way of another surface, or it is not to be computed.
  bool skips_indirect() const { return limits && !simulates(Effect::diffuse_indirect) && !simulates(Effect::glossy_chain); }
};

}  // namespace gibench
