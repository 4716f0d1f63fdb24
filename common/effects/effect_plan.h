/// The effects that a scene may call for, and the plan that a method works under.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

namespace gibench {

/// A class of light paths, or a property of the scene that costs work.
enum class Effect {
  direct,               ///< light straight from a light
  diffuse_indirect,     ///< diffuse interreflection
  glossy_final_bounce,  ///< a glossy surface that a camera or a query sees
  glossy_chain,         ///< glossy surfaces that light other surfaces: caustics
  environment,          ///< light from an environment
  occlusion,            ///< surfaces that hide one another
};
using EffectSet = std::set<Effect>;

const char* to_string(Effect effect);
/// One line for people.
const char* meaning_of(Effect effect);
const std::vector<Effect>& all_effects();

struct SkippedEffect {
  Effect effect;
  std::string why;
};

/// called for by the scene ∩ what the method can do, the bounce bound, and the reason for each thing skipped.
struct EffectPlan {
  EffectSet called_for;
  EffectSet simulated;                 ///< what prepare(), light() and shade() are to compute
  EffectSet missing;                   ///< called for, but beyond the method
  std::vector<SkippedEffect> skipped;  ///< not called for: not computed
  std::optional<int> max_bounces;      ///< reflections between a light and the surface asked about; empty: no bound
};

}  // namespace gibench
