#include "bench/record/effect_record.h"

#include "bench/record/json_fields.h"

namespace gibench {

namespace {

Json name_list(const EffectSet& effects) {
  Json names = Json::array();
  for (const Effect effect : effects) names.push_back(to_string(effect));
  return names;
}

EffectSet effects_in(const Json& json, const char* name) {
  std::vector<std::string> names;
  read_field(json, name, names);
  return effects_of_names(names, name);
}

}  // namespace

Json to_json(const EffectPlan& plan) {
  Json skipped = Json::array();
  for (const SkippedEffect& effect : plan.skipped) skipped.push_back({{"effect", to_string(effect.effect)}, {"why", effect.why}});
  Json json{{"called_for", name_list(plan.called_for)},
            {"simulated", name_list(plan.simulated)},
            {"missing", name_list(plan.missing)},
            {"skipped", std::move(skipped)}};
  write_field(json, "max_bounces", plan.max_bounces);
  return json;
}

EffectPlan effect_plan_of(const Json& json) {
  EffectPlan plan;
  plan.called_for = effects_in(json, "called_for");
  plan.simulated = effects_in(json, "simulated");
  plan.missing = effects_in(json, "missing");
  for (const Json& skipped : object_field(json, "skipped"))
    plan.skipped.push_back(
        {known_name(all_effects(), skipped.at("effect").get<std::string>(), "skipped"), skipped.at("why").get<std::string>()});
  read_field(json, "max_bounces", plan.max_bounces);
  return plan;
}

Json to_json(const std::vector<EffectEvidence>& effects) {
  Json list = Json::array();
  for (const EffectEvidence& e : effects)
    list.push_back({{"effect", to_string(e.effect)}, {"called_for", e.called_for}, {"evidence", e.why}});
  return list;
}

std::vector<EffectEvidence> evidence_of(const Json& json) {
  std::vector<EffectEvidence> effects;
  for (const Json& entry : json)
    effects.push_back({known_name(all_effects(), entry.at("effect").get<std::string>(), "effects"),
                       entry.at("called_for").get<bool>(), entry.at("evidence").get<std::string>()});
  return effects;
}

BoundRecord BoundRecord::of(const SceneEffects& effects) {
  const bool asked = effects.limits.tolerance > 0.0;
  return {asked ? effects.limits.tolerance : usual_tolerance, effects.bound.most, asked && effects.bound.most.has_value(),
          effects.bound.why};
}

Json to_json(const BoundRecord& bound) {
  Json json{{"tolerance", bound.tolerance}};
  write_field(json, "most", bound.most);
  json["binds"] = bound.binds;
  json["evidence"] = bound.evidence;
  return json;
}

BoundRecord bound_record_of(const Json& json) {
  BoundRecord bound;
  read_field(json, "tolerance", bound.tolerance);
  read_field(json, "most", bound.most);
  read_field(json, "binds", bound.binds);
  read_field(json, "evidence", bound.evidence);
  return bound;
}

}  // namespace gibench
