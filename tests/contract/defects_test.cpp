/// The contract catches a method that breaks it: every check is shown a method made to fail it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <vector>

#include "tests/contract/ambient_method.h"
#include "tests/contract/contract.h"

namespace gibench::contract {
namespace {

class SoundMethod : public testing::TestWithParam<std::size_t> {};

TEST_P(SoundMethod, KeepsTheContract) { EXPECT_EQ(violation_of(all_checks()[GetParam()], ambient_method()), ""); }

INSTANTIATE_TEST_SUITE_P(EveryCheck, SoundMethod, testing::Range<std::size_t>(0, all_checks().size()),
                         [](const auto& check) { return std::string(all_checks()[check.param].name); });

/// A defect, the check that has to catch it, and a part of what the check has to say.
struct Case {
  const char* name;
  Defect defect;
  const char* check;
  const char* message;
};

class TheContractCatches : public testing::TestWithParam<Case> {};

TEST_P(TheContractCatches, AMethodThat) {
  const Case& one = GetParam();
  EXPECT_THAT(violation_of(find_check(one.check), ambient_method(one.defect)), testing::HasSubstr(one.message));
}

constexpr Case cases[] = {
    {"AddsAConstant", Defect::adds_a_constant, "DoublingTheLightDoublesTheAnswer", "under 2 times the light"},
    {"DropsDimLight", Defect::drops_dim_light, "DoublingTheLightDoublesTheAnswer", "e-07 times the light"},
    {"SeesOneKindOfLight", Defect::sees_one_kind_of_light, "TwoLightsAdd", "the sum of two lights"},
    {"PilesUpRelitLight", Defect::piles_up_relit_light, "RelightingEqualsAFreshRun", "a fresh run against a relit one"},
    {"KnowsTheMetre", Defect::knows_the_metre, "ScaleInvariance", "in a room of a millimetre"},
    {"KnowsTheVertical", Defect::knows_the_vertical, "RotationInvariance", "in a room that was turned"},
    {"IsOffByLessThanAPlacement", Defect::is_a_little_off, "RotationInvariance", "in a room that was turned"},
    {"ReflectsOffBlack", Defect::reflects_off_black, "BlackWallsGiveNoIndirectLight", "between black walls"},
    {"IgnoresTheBound", Defect::ignores_the_bound, "BounceBounds", "at most 0 bounces"},
    {"DimsWithBounces", Defect::dims_with_bounces, "BounceBounds", "falls by"},
    {"LeavesAGap", Defect::leaves_a_gap, "EveryValueIsWrittenAndFinite", "was not written or is not finite"},
    {"WritesNotANumber", Defect::writes_not_a_number, "EveryValueIsWrittenAndFinite", "was not written or is not finite"},
    {"LightsTheBacks", Defect::lights_the_backs, "EveryValueIsWrittenAndFinite", "on a back"},
    {"GoesBelowZero", Defect::goes_below_zero, "EveryValueIsWrittenAndFinite", "below zero"},
    {"ClaimsNegativeVariance", Defect::claims_negative_variance, "EveryValueIsWrittenAndFinite", "a variance"},
    {"RefusesPlainScenes", Defect::refuses_plain_scenes, "EveryValueIsWrittenAndFinite", "is refused: there are surfaces"},
    {"RefusesWithACode", Defect::refuses_with_a_code, "RefusalsAreTexts", "E17"},
    {"RefusesByTurns", Defect::refuses_by_turns, "RefusalsAreTexts", "not the same again"},
    {"CountsItsThreads", Defect::counts_its_threads, "SameSeedSameBits", "one thread against two"},
    {"DrawsUnkeyedNumbers", Defect::draws_unkeyed_numbers, "RelightingEqualsAFreshRun", "a fresh run against a relit one"},
    {"WorksOnWhenCancelled", Defect::works_on_when_cancelled, "CancellingStopsSoon", "more rays"},
    {"LooksForWhatHides", Defect::looks_for_what_hides, "AConvexRoomNeedsNoVisibilityRays", "occlusion rays"},
    {"WorksWithoutLight", Defect::works_for_nothing, "NoLightNeedsNoWork", "rays were traced"},
    {"WorksBetweenBlackWalls", Defect::works_for_nothing, "BlackWallsNeedNoIndirectWork", "rays were traced"},
    {"MisnamesItsPaths", Defect::misnames_its_paths, "LightPathsAreTold", "more than 0 bounces"},
    {"AnswersRadianceAlone", Defect::answers_radiance_alone, "TheEntryDescribesItself", "does not answer irradiance"},
    {"ClaimsUnseenLobes", Defect::claims_unseen_lobes, "TheEntryDescribesItself", "does not answer radiance"},
    {"KnowsVarianceByHalves", Defect::knows_variance_by_halves, "EveryQuestionIsAnswered", "the variance of sample 0"},
    {"AnswersRadianceAloneWhenAsked", Defect::answers_radiance_alone, "EveryQuestionIsAnswered", "irradiance is not answered"},
    {"AnswersPartsOtherwise", Defect::answers_parts_otherwise, "PartsAreThoseOfTheWhole", "indirect light alone"},
    {"OverlooksEdits", Defect::overlooks_edits, "EditingEqualsAFreshRun", "a fresh run against an edited one"},
    {"KeepsWhatWasCancelled", Defect::keeps_what_was_cancelled, "CancellingStopsSoon", "follows a cancelled one"},
};

INSTANTIATE_TEST_SUITE_P(EveryDefect, TheContractCatches, testing::ValuesIn(cases),
                         [](const auto& one) { return std::string(one.param.name); });

/// In the dark no method is asked: what it would say is not heard.
TEST(TheInterface, AnswersForTheMethodInTheDark) {
  EXPECT_EQ(violation_of(find_check("NoLightGivesBlack"), ambient_method(Defect::glows_without_light)), "");
  EXPECT_EQ(violation_of(find_check("NoLightGivesBlack"), ambient_method(Defect::piles_up_relit_light)), "");
}

/// A method that answers irradiance alone keeps the whole contract: what else is asked of it follows from that.
class IrradianceAlone : public testing::TestWithParam<std::size_t> {};

TEST_P(IrradianceAlone, KeepsTheContract) {
  EXPECT_EQ(violation_of(all_checks()[GetParam()], ambient_method(Defect::answers_irradiance_alone)), "");
}

INSTANTIATE_TEST_SUITE_P(EveryCheck, IrradianceAlone, testing::Range<std::size_t>(0, all_checks().size()),
                         [](const auto& check) { return std::string(all_checks()[check.param].name); });

/// What an entry can say wrongly, and what has to be said about it.
struct WrongEntry {
  const char* name;
  void (*spoil)(MethodEntry&);
  const char* check;
  const char* message;
};

class TheContractCatchesAnEntry : public testing::TestWithParam<WrongEntry> {};

TEST_P(TheContractCatchesAnEntry, That) {
  MethodEntry entry = ambient_method();
  GetParam().spoil(entry);
  EXPECT_THAT(violation_of(find_check(GetParam().check), entry), testing::HasSubstr(GetParam().message));
}

const WrongEntry wrong_entries[] = {
    {"HasNoSummary", [](MethodEntry& e) { e.summary.clear(); }, "TheEntryDescribesItself", "summary"},
    {"HasTwoLinesOfSource", [](MethodEntry& e) { e.source = "a\nb"; }, "TheEntryDescribesItself", "source"},
    {"HasNoLightPaths", [](MethodEntry& e) { e.light_paths = "C<D>*[<LO>]"; }, "LightPathsAreTold", "not an expression"},
    {"HasNoPlainName", [](MethodEntry& e) { e.name = "Am bient"; }, "TheEntryDescribesItself", "not a plain name"},
    {"TakesWhatItShouldNotKnow",
     [](MethodEntry& e) {
       e.schema.push_back({"no_such_parameter", true, 0, 0, {}, "a trap"});
     },
     "UnknownParametersAreRefused", "'no_such_parameter' is taken"},
    {"TakesAMisspelling",
     [](MethodEntry& e) {
       e.schema.push_back({"points_", true, 0, 0, {}, "a trap"});
     },
     "UnknownParametersAreRefused", "'points_' is taken"},
    {"HasADefaultOutOfRange", [](MethodEntry& e) { e.schema[0].default_value = std::int64_t{65}; },
     "ParametersDescribeThemselves", "outside its range"},
    {"HasARealDefaultOutOfRange", [](MethodEntry& e) { e.schema[1].default_value = -0.5; }, "ParametersDescribeThemselves",
     "outside its range"},
    {"HasADefaultThatIsNoChoice", [](MethodEntry& e) { e.schema[3].default_value = std::string("flat"); },
     "ParametersDescribeThemselves", "the default of shape is refused"},
    {"HasTheSameParameterTwice", [](MethodEntry& e) { e.schema.push_back(e.schema[0]); }, "ParametersDescribeThemselves",
     "two parameters called points"},
    {"HasNoPlainParameterName", [](MethodEntry& e) { e.schema[2].name = "lively?"; }, "ParametersDescribeThemselves",
     "not a plain name"},
    {"DoesNotSayWhatItMeans", [](MethodEntry& e) { e.schema[2].meaning.clear(); }, "ParametersDescribeThemselves",
     "lively does not say"},
    {"HasAPresetOfWhatItDoesNotHave",
     [](MethodEntry& e) {
       e.presets = {{"paper", "of the text", {{"point", "4"}}}};
     },
     "PresetsCanBeChosen", "'point'"},
    {"HasAPresetOutOfRange",
     [](MethodEntry& e) {
       e.presets = {{"paper", "of the text", {{"points", "65"}}}};
     },
     "PresetsCanBeChosen", "points=65 is not valid"},
    {"HasAPresetThatSaysNothing",
     [](MethodEntry& e) {
       e.presets = {{"paper", "", {}}};
     },
     "PresetsCanBeChosen", "paper does not say"},
    {"HasAPresetTwice",
     [](MethodEntry& e) {
       e.presets.assign(2, {"paper", "of the text", {}});
     },
     "PresetsCanBeChosen", "two presets called paper"},
};

INSTANTIATE_TEST_SUITE_P(EveryMistake, TheContractCatchesAnEntry, testing::ValuesIn(wrong_entries),
                         [](const auto& one) { return std::string(one.param.name); });

/// Promises that the interface keeps whatever a method does: its tests are those of common/method.
constexpr const char* kept_by_the_interface[] = {"NoLightGivesBlack", "WhatIsNotAllowedIsNotComputed"};

/// A check without a defect to its name is a check nobody has seen fail.
TEST(Defects, ThereIsOneForEveryCheck) {
  for (const Check& check : all_checks()) {
    bool shown = false;
    for (const char* kept : kept_by_the_interface) shown |= std::string(kept) == check.name;
    for (const Case& one : cases) shown |= std::string(one.check) == check.name;
    for (const WrongEntry& one : wrong_entries) shown |= std::string(one.check) == check.name;
    EXPECT_TRUE(shown) << check.name;
  }
}

}  // namespace
}  // namespace gibench::contract
