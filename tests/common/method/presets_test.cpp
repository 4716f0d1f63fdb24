#include "common/method/presets.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/core/error.h"
#include "common/method/parameters.h"

namespace gibench {
namespace {

const std::vector<Preset> presets{{"paper", "as in the text", {{"rays", "512"}, {"levels", "6"}}}, {"rough", "soon done", {}}};

TEST(Presets, OwnSettingsOverrideThoseOfThePreset) {
  const ParameterSchema schema{{"rays", std::int64_t{64}, 1, 1000, {}, ""}, {"levels", std::int64_t{3}, 1, 12, {}, ""}};
  const Parameters plain(schema, with_preset(presets, "paper", {}));
  EXPECT_EQ(plain.whole("rays"), 512);
  EXPECT_EQ(plain.whole("levels"), 6);
  const Parameters overridden(schema, with_preset(presets, "paper", {{"levels", "2"}}));
  EXPECT_EQ(overridden.whole("rays"), 512);
  EXPECT_EQ(overridden.whole("levels"), 2);
}

TEST(Presets, WithoutANameThereAreTheDefaults) {
  EXPECT_EQ(with_preset(presets, "", {{"levels", "2"}}), (SettingTexts{{"levels", "2"}}));
}

TEST(Presets, AnUnknownNameIsRefusedWithTheKnown) {
  try {
    with_preset(presets, "papers", {}, "somewhere");
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(testing::HasSubstr("somewhere"), testing::HasSubstr("papers"),
                                             testing::HasSubstr("did you mean"), testing::HasSubstr("rough")));
  }
  try {
    with_preset({}, "paper", {});
    FAIL() << "taken";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("--preset"));
  }
}

}  // namespace
}  // namespace gibench
