#include "tests/contract/contract.h"

#include <algorithm>
#include <array>
#include <utility>

namespace gibench::contract {

std::span<const Check> all_checks() {
  static constexpr std::array<Check, 24> checks{{
      {"DoublingTheLightDoublesTheAnswer", verify_doubling_the_light_doubles_the_answer},
      {"TwoLightsAdd", verify_two_lights_add},
      {"NoLightGivesBlack", verify_no_light_gives_black},
      {"RelightingEqualsAFreshRun", verify_relighting_equals_a_fresh_run},
      {"ScaleInvariance", verify_scale_invariance},
      {"RotationInvariance", verify_rotation_invariance},
      {"BlackWallsGiveNoIndirectLight", verify_black_walls_give_no_indirect_light},
      {"BounceBounds", verify_bounce_bounds},
      {"EveryValueIsWrittenAndFinite", verify_every_value_is_written_and_finite},
      {"RefusalsAreTexts", verify_refusals_are_texts},
      {"AConvexRoomNeedsNoVisibilityRays", verify_a_convex_room_needs_no_visibility_rays},
      {"NoLightNeedsNoWork", verify_no_light_needs_no_work},
      {"BlackWallsNeedNoIndirectWork", verify_black_walls_need_no_indirect_work},
      {"WhatIsNotAllowedIsNotComputed", verify_what_is_not_allowed_is_not_computed},
      {"LightPathsAreTold", verify_light_paths_are_told},
      {"SameSeedSameBits", verify_same_seed_same_bits},
      {"CancellingStopsSoon", verify_cancelling_stops_soon},
      {"EveryQuestionIsAnswered", verify_every_question_is_answered},
      {"PartsAreThoseOfTheWhole", verify_parts_are_those_of_the_whole},
      {"EditingEqualsAFreshRun", verify_editing_equals_a_fresh_run},
      {"TheEntryDescribesItself", verify_the_entry_describes_itself},
      {"UnknownParametersAreRefused", verify_unknown_parameters_are_refused},
      {"ParametersDescribeThemselves", verify_parameters_describe_themselves},
      {"PresetsCanBeChosen", verify_presets_can_be_chosen},
  }};
  return checks;
}

const Check& find_check(const std::string& name) {
  const auto checks = all_checks();
  const auto found = std::find_if(checks.begin(), checks.end(), [&](const Check& check) { return check.name == name; });
  if (found == checks.end()) throw std::out_of_range("no check is called " + name);
  return *found;
}

std::vector<MethodEntry> techniques_of(const MethodEntry& entry) {
  const auto chosen = std::find_if(entry.schema.begin(), entry.schema.end(),
                                   [&](const ParameterSpec& spec) { return spec.name == entry.technique_parameter; });
  if (chosen == entry.schema.end()) return {entry};
  std::vector<MethodEntry> techniques;
  for (const std::string& choice : chosen->choices) {
    MethodEntry technique = entry;
    technique.quick.emplace_back(chosen->name, choice);
    technique.name += "_" + choice;
    std::replace(technique.name.begin(), technique.name.end(), '-', '_');
    techniques.push_back(std::move(technique));
  }
  return techniques;
}

std::string violation_of(const Check& check, const MethodEntry& entry) {
  try {
    check.verify(entry);
    return {};
  } catch (const Violation& violation) {
    return violation.what();
  }
}

}  // namespace gibench::contract
