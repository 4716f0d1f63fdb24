#include "common/effects/effect_plan.h"

#include "common/effects/scene_effects.h"

namespace gibench {

const char* to_string(Effect effect) {
  switch (effect) {
    case Effect::direct: return "direct";
    case Effect::diffuse_indirect: return "diffuse_indirect";
    case Effect::glossy_final_bounce: return "glossy_final_bounce";
    case Effect::glossy_chain: return "glossy_chain";
    case Effect::environment: return "environment";
    case Effect::occlusion: return "occlusion";
  }
  return "unknown";
}

const char* meaning_of(Effect effect) {
  switch (effect) {
    case Effect::direct: return "light straight from a light";
    case Effect::diffuse_indirect: return "diffuse interreflection";
    case Effect::glossy_final_bounce: return "a glossy surface that a camera or a query sees";
    case Effect::glossy_chain: return "glossy surfaces that light other surfaces";
    case Effect::environment: return "light from an environment";
    case Effect::occlusion: return "surfaces that hide one another";
  }
  return "unknown";
}

const std::vector<Effect>& all_effects() {
  static const std::vector<Effect> effects{Effect::direct,       Effect::diffuse_indirect, Effect::glossy_final_bounce,
                                           Effect::glossy_chain, Effect::environment,      Effect::occlusion};
  return effects;
}

EffectPlan plan_effects(const SceneEffects& scene, const EffectSet& can_do) {
  EffectPlan plan;
  plan.max_bounces = scene.max_bounces;
  for (const EffectEvidence& evidence : scene.effects) {
    if (!evidence.called_for) {
      plan.skipped.push_back({evidence.effect, evidence.why});
      continue;
    }
    plan.called_for.insert(evidence.effect);
    (can_do.contains(evidence.effect) ? plan.simulated : plan.missing).insert(evidence.effect);
  }
  return plan;
}

}  // namespace gibench
