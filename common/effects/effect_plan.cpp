#include "common/effects/effect_plan.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "common/core/error.h"
#include "common/core/names.h"

namespace gibench {

const char* to_string(Effect effect) {
  switch (effect) {
    case Effect::direct: return "direct";
    case Effect::diffuse_indirect: return "diffuse_indirect";
    case Effect::glossy_final_bounce: return "glossy_final_bounce";
    case Effect::glossy_chain: return "glossy_chain";
    case Effect::environment: return "environment";
    case Effect::occlusion: return "occlusion";
    case Effect::two_sided: return "two_sided";
    case Effect::colour: return "colour";
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
    case Effect::two_sided: return "surfaces that reflect on both sides";
    case Effect::colour: return "surfaces or lights whose channels differ";
  }
  return "unknown";
}

const std::vector<Effect>& all_effects() {
  static const std::vector<Effect> effects{
      Effect::direct,      Effect::diffuse_indirect, Effect::glossy_final_bounce, Effect::glossy_chain,
      Effect::environment, Effect::occlusion,        Effect::two_sided,           Effect::colour};
  return effects;
}

const EffectSet& scene_properties() {
  static const EffectSet properties{Effect::occlusion, Effect::two_sided, Effect::colour};
  return properties;
}

namespace {

std::string known_effects(const std::string& unknown) {
  std::vector<std::string> names;
  for (const Effect effect : all_effects()) names.emplace_back(to_string(effect));
  return known_names("known", unknown, names);
}

}  // namespace

EffectSet effects_of_names(const std::vector<std::string>& names, const std::string& place) {
  EffectSet effects;
  for (const std::string& name : names) {
    bool known = false;
    for (const Effect effect : all_effects())
      if (name == to_string(effect)) effects.insert(effect), known = true;
    if (!known) throw InputError(place, fmt::format("unknown effect '{}'", name), known_effects(name));
  }
  return effects;
}

std::string names_of(const EffectSet& effects) {
  std::vector<std::string> names;
  for (const Effect effect : effects) names.emplace_back(to_string(effect));
  return fmt::format("{}", fmt::join(names, ", "));
}

}  // namespace gibench
