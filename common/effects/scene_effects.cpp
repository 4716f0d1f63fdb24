#include "common/effects/scene_effects.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/error.h"
#include "common/effects/sealed.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

std::string light_evidence(const SceneFacts& facts) {
  std::string text;
  const auto append = [&](const std::string& part) { text += (text.empty() ? "" : ", ") + part; };
  const auto count = [&](std::size_t number, const std::string& what) {
    if (number > 0) append(fmt::format("{} {}{}", number, what, number == 1 ? "" : "s"));
  };
  const LightCounts& lights = facts.lights;
  if (lights.emitting_materials > 0)
    append(fmt::format("{} emitting material{} ('{}')", lights.emitting_materials, lights.emitting_materials == 1 ? "" : "s",
                       facts.first_emitter));
  for (std::size_t kind = 0; kind < lights.of_kind.size(); ++kind)
    count(lights.of_kind[kind], light_kinds()[kind].name + std::string(" light"));
  return text;
}

/// The verdict on light that one surface throws on another; empty: nothing speaks against it.
std::string no_interreflection(const SceneEffects& scene) {
  if (scene.max_bounces == 0)
    return scene.limits.bounces == 0 ? "0 bounces asked for" : "no reflection is planned: " + scene.bound.why;
  if (scene.arrangement == Arrangement::no_mutual_sight) return "no surface sees the front of another";
  return {};
}

EffectEvidence diffuse_indirect(const SceneFacts& facts, const std::string& prevented) {
  if (facts.brightest_diffuse.empty()) return {Effect::diffuse_indirect, false, "every diffuse albedo is 0"};
  if (!prevented.empty()) return {Effect::diffuse_indirect, false, prevented};
  return {Effect::diffuse_indirect, true,
          fmt::format("diffuse albedo up to {:.3g} ('{}')", facts.largest_albedo, facts.brightest_diffuse)};
}

EffectEvidence glossy(Effect effect, const SceneFacts& facts, const std::string& prevented) {
  if (facts.glossy.empty()) return {effect, false, "no material is glossy"};
  if (!prevented.empty()) return {effect, false, prevented};
  const std::string more = facts.glossy_materials > 1 ? fmt::format(" and {} more", facts.glossy_materials - 1) : "";
  return {effect, true,
          fmt::format("glossy material '{}'{} on {:.3g}% of the surfaces", facts.glossy, more, 100.0 * facts.glossy_area)};
}

EffectEvidence environment(const SceneFacts& facts, bool sealed) {
  if (facts.lights.background() == 0) return {Effect::environment, false, "no environment light"};
  if (sealed) return {Effect::environment, false, "the scene is closed: nothing of its environment reaches a surface"};
  return {Effect::environment, true, "an environment light"};
}

EffectEvidence occlusion(const World& world, const Lighting& lighting, const SceneEffects& scene) {
  if (lights_may_be_hidden(world, scene.arrangement, scene.sealed, lighting))
    return {Effect::occlusion, true,
            scene.arrangement == Arrangement::general ? "surfaces may hide one another"
                                                      : "one convex room, but a light outside it may be hidden"};
  return {Effect::occlusion, false,
          scene.arrangement == Arrangement::convex_room ? "one convex room: every front sees every other and every light"
                                                        : "every surface lies behind every other: nothing is hidden"};
}

std::optional<int> smaller(std::optional<int> a, std::optional<int> b) { return a && b ? std::min(*a, *b) : a ? a : b; }

/// What lies at infinity gives a sealed scene nothing.
Lighting without_the_outside(Lighting lighting) {
  std::erase_if(lighting.lights, [](const Light& light) { return kind_of(light).at_infinity; });
  return lighting;
}

}  // namespace

const EffectEvidence& SceneEffects::operator[](Effect effect) const {
  const auto found = std::find_if(effects.begin(), effects.end(), [&](const EffectEvidence& e) { return e.effect == effect; });
  GIBENCH_CHECK(found != effects.end(), "an analysis decides about every effect");
  return *found;
}

EffectSet SceneEffects::called_for() const {
  EffectSet set;
  for (const EffectEvidence& evidence : effects)
    if (evidence.called_for) set.insert(evidence.effect);
  return set;
}

SceneEffects analyse_effects(const World& world, const Lighting& lighting, const PlanLimits& limits) {
  SceneEffects result;
  result.limits = limits;
  result.changes = changes_of(world.scene());
  SceneFacts facts(world, lighting);
  result.sealed = facts.lights.at_infinity() > 0 && is_sealed(world);
  const EffectEvidence sky = environment(facts, result.sealed);
  if (result.sealed) facts = SceneFacts(world, without_the_outside(lighting));
  const bool asked = limits.tolerance > 0.0;
  result.bound = bounce_bound(reflectances_of(world), asked ? limits.tolerance : usual_tolerance);
  result.max_bounces = smaller(limits.bounces, asked ? result.bound.most : std::nullopt);
  result.lights = facts.lights;
  result.grey_surfaces = facts.grey_surfaces;
  result.events = facts.events;
  result.unlit = !facts.lights.any();
  if (result.unlit) {
    const std::string why =
        result.sealed ? "the scene has no light: it is closed, and its lights lie outside" : "the scene has no light";
    for (const Effect effect : all_effects()) result.effects.push_back({effect, false, why});
    return result;
  }
  result.arrangement = arrangement_of(world);
  const std::string prevented = no_interreflection(result);
  result.effects = {{Effect::direct, true, light_evidence(facts)},
                    diffuse_indirect(facts, prevented),
                    glossy(Effect::glossy_final_bounce, facts, {}),
                    glossy(Effect::glossy_chain, facts, prevented),
                    sky,
                    occlusion(world, lighting, result),
                    {Effect::two_sided, !facts.two_sided.empty(),
                     facts.two_sided.empty() ? "every back is black" : fmt::format("two-sided object '{}'", facts.two_sided)},
                    {Effect::colour, !facts.coloured.empty(),
                     facts.coloured.empty() ? "grey surfaces and grey lights: one channel stands for three"
                                            : fmt::format("coloured: {}", facts.coloured)}};
  return result;
}

SceneEffects analyse_effects(const World& world, const PlanLimits& limits) {
  return analyse_effects(world, Lighting::of(world.scene()), limits);
}

SceneEffects analyse_effects(const World& world, std::optional<int> bounces) {
  PlanLimits limits;
  limits.bounces = bounces;
  return analyse_effects(world, limits);
}

EffectPlan plan_effects(const SceneEffects& scene, const EffectSet& can_do) {
  EffectPlan plan;
  plan.max_bounces = scene.max_bounces;
  plan.arrangement = scene.arrangement;
  plan.sealed = scene.sealed;
  plan.unlit = scene.unlit;
  plan.grey_surfaces = scene.grey_surfaces;
  plan.changes = scene.changes;
  plan.limits = scene.limits;
  const PlanLimits& limits = scene.limits;
  for (const EffectEvidence& evidence : scene.effects) {
    const Effect effect = evidence.effect;
    const bool can = can_do.contains(effect) || effect == Effect::two_sided || effect == Effect::colour;
    if (!evidence.called_for) {
      if (limits.forced.contains(effect)) plan.simulated.insert(effect);
      else plan.skipped.push_back({effect, evidence.why});
      continue;
    }
    plan.called_for.insert(effect);
    if (limits.allowed && !limits.allowed->contains(effect) && !scene_properties().contains(effect))
      plan.skipped.push_back({effect, "called for, but not among the effects allowed"});
    else (can ? plan.simulated : plan.missing).insert(effect);
  }
  return plan;
}

}  // namespace gibench
