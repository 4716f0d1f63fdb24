#include "common/method/parameters.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "common/core/error.h"
#include "tests/support/check_failed.h"

namespace gibench {
namespace {

using testing::HasSubstr;

const ParameterSchema& schema() {
  static const ParameterSchema made{
      {"levels", std::int64_t{6}, 1, 20, {}, "levels of the hierarchy"},
      {"tolerance", 1e-3, 0.0, 1.0, {}, "relative residual"},
      {"final_gather", false, 0, 0, {}, "gather at every sample"},
      {"mode", std::string("fast"), 0, 0, {"fast", "exact"}, "how"},
  };
  return made;
}

/// The message of the InputError that these settings give; empty where they are accepted.
std::string message_of(const std::string& name, const std::string& text) {
  try {
    const Parameters accepted(schema(), {{name, text}}, "study.json /runs/0");
    return {};
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Parameters, DefaultsHoldUnlessSet) {
  const Parameters defaults(schema(), {});
  EXPECT_EQ(defaults.whole("levels"), 6);
  EXPECT_EQ(defaults.real("tolerance"), 1e-3);
  EXPECT_FALSE(defaults.flag("final_gather"));
  EXPECT_EQ(defaults.text("mode"), "fast");
  EXPECT_EQ(defaults.values().size(), schema().size());
  const Parameters set(schema(), {{"levels", "3"}, {"tolerance", "0.5"}, {"final_gather", "true"}, {"mode", "exact"}});
  EXPECT_EQ(set.whole("levels"), 3);
  EXPECT_EQ(set.real("tolerance"), 0.5);
  EXPECT_TRUE(set.flag("final_gather"));
  EXPECT_EQ(set.text("mode"), "exact");
}

TEST(Parameters, AnUnknownNameIsRefusedWithTheKnownOnes) {
  const std::string message = message_of("level", "3");
  EXPECT_THAT(message, HasSubstr("study.json /runs/0"));
  EXPECT_THAT(message, HasSubstr("'level'"));
  for (const ParameterSpec& spec : schema()) EXPECT_THAT(message, HasSubstr(spec.name));
}

TEST(Parameters, AWrongValueIsRefusedWithItsRange) {
  EXPECT_THAT(message_of("levels", "0"), HasSubstr("1..20"));
  EXPECT_THAT(message_of("levels", "21"), HasSubstr("1..20"));
  EXPECT_THAT(message_of("levels", "3.5"), HasSubstr("whole number"));
  EXPECT_THAT(message_of("levels", ""), HasSubstr("whole number"));
  EXPECT_THAT(message_of("levels", "99999999999999999999"), HasSubstr("whole number"));
  EXPECT_THAT(message_of("tolerance", "nan"), HasSubstr("0"));
  EXPECT_THAT(message_of("tolerance", "inf"), HasSubstr("real number"));
  EXPECT_THAT(message_of("tolerance", "1e-3x"), HasSubstr("real number"));
  EXPECT_THAT(message_of("final_gather", "yes"), HasSubstr("true|false"));
  EXPECT_THAT(message_of("mode", "slow"), HasSubstr("fast|exact"));
  EXPECT_EQ(message_of("levels", "20"), "");
  EXPECT_EQ(message_of("tolerance", "1"), "");
}

TEST(Parameters, TextReadsBackAsTheSameValue) {
  const Parameters set(schema(), {{"tolerance", "0.1"}, {"levels", "7"}, {"final_gather", "1"}});
  std::vector<std::pair<std::string, std::string>> written;
  for (const auto& [name, value] : set.values()) written.emplace_back(name, to_text(value));
  EXPECT_EQ(Parameters(schema(), written).values(), set.values());
}

TEST(Parameters, ReadingBesideTheSchemaIsAProgrammersError) {
  const Parameters defaults(schema(), {});
  EXPECT_THAT([&] { defaults.whole("depth"); }, test::fails_check("only parameters of its schema"));
}

}  // namespace
}  // namespace gibench
