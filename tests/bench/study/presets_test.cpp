/// Presets in study files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "bench/study/study_file.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "tests/support/scratch_folder.h"

namespace gibench {
namespace {

using nlohmann::json;

Study study_with(const json& method) {
  const test::ScratchFolder folder;
  const std::filesystem::path file = folder.path() / "presets.study.json";
  const json study{{"gibench_study", 1}, {"name", "presets"}, {"scenes", {"cornell-box"}}, {"methods", {method}}};
  write_file_atomically(file, study.dump());
  return read_study(file);
}

TEST(StudyPresets, ParametersAndSweepsOverrideThem) {
  const Study study = study_with(
      {{"method", "meshless"}, {"preset", "paper"}, {"parameters", {{"levels", 3}}}, {"sweep", {{"epsilon_E", {0.04, 0.02}}}}});
  ASSERT_EQ(study.variants.size(), 2U);
  for (const StudyVariant& variant : study.variants) {
    EXPECT_EQ(variant.parameters.at("noise_guard"), ParameterValue(0.0));
    EXPECT_EQ(variant.parameters.at("levels"), ParameterValue(std::int64_t{3}));
  }
  EXPECT_EQ(study.variants[1].parameters.at("epsilon_E"), ParameterValue(0.02));
  EXPECT_THAT(study.variants[1].settings, testing::IsSupersetOf({"noise_guard=0", "epsilon_E=0.02"}));
}

TEST(StudyPresets, AnUnknownOneIsRefusedAtItsPlace) {
  try {
    study_with({{"method", "spectral"}, {"preset", "papr"}});
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                testing::AllOf(testing::HasSubstr("preset"), testing::HasSubstr("\"papr\""), testing::HasSubstr("paper")));
  }
}

}  // namespace
}  // namespace gibench
