#include "common/method/parameter_table.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/check_failed.h"

namespace gibench {
namespace {

enum class Shape { round, square };

struct Settings {
  int count = 6;
  std::uint64_t large = 64;
  float narrow = 0.01F;
  double wide = 0.3141592653589793;
  bool on = true;
  Shape shape = Shape::square;
  bool near = false;

  bool operator==(const Settings&) const = default;
};

const ParameterTable<Settings>& table() {
  static const ParameterTable<Settings> made{
      parameter("count", &Settings::count, 1, 20, "how many"),
      parameter("large", &Settings::large, 0, 4294967295.0, "a number beyond 31 bits"),
      parameter("narrow", &Settings::narrow, 0.0, 1.0, "a number in single precision"),
      parameter("wide", &Settings::wide, 0.0, 12.6, "a number in double precision"),
      parameter("on", &Settings::on, "whether"),
      parameter("shape", &Settings::shape, {{"round", Shape::round}, {"square", Shape::square}}, "which shape"),
      parameter("field", &Settings::near, {{"near", true}, {"far", false}}, "two words for a flag"),
  };
  return made;
}

Settings read(const std::vector<std::pair<std::string, std::string>>& settings) {
  return table().read(Parameters(table().schema(), settings));
}

TEST(ParameterTable, TheSchemaHoldsTheMembersInitialValuesInTheOrderOfTheRows) {
  const ParameterSchema schema = table().schema();
  std::vector<std::string> names, defaults;
  for (const ParameterSpec& spec : schema) names.push_back(spec.name), defaults.push_back(to_text(spec.default_value));
  EXPECT_THAT(names, testing::ElementsAre("count", "large", "narrow", "wide", "on", "shape", "field"));
  EXPECT_THAT(defaults, testing::ElementsAre("6", "64", "0.01", "0.3141592653589793", "true", "square", "far"));
  EXPECT_EQ(describe_type(schema[0]), "whole number 1..20");
  EXPECT_EQ(describe_type(schema[2]), "real number 0..1");
  EXPECT_EQ(describe_type(schema[4]), "true|false");
  EXPECT_EQ(describe_type(schema[5]), "word, one of round|square");
  EXPECT_EQ(schema[1].meaning, "a number beyond 31 bits");
}

TEST(ParameterTable, DefaultsAreReadBackAsDefaultConstructedSettings) { EXPECT_EQ(read({}), Settings()); }

TEST(ParameterTable, EachParameterReachesItsMember) {
  Settings wanted{7, 4294967295U, 0.1F, 0.1, false, Shape::round, true};
  EXPECT_EQ(read({{"count", "7"},
                  {"large", "4294967295"},
                  {"narrow", "0.1"},
                  {"wide", "0.1"},
                  {"on", "false"},
                  {"shape", "round"},
                  {"field", "near"}}),
            wanted);
}

TEST(ParameterTable, ANumberInSinglePrecisionIsShownAsItIsWritten) {
  for (const float value : {0.0F, 0.01F, 0.02F, 0.15F, 1e-5F, 40.0F, 1.0F / 3.0F, 3.4e38F})
    EXPECT_EQ(static_cast<float>(as_written(value)), value);
  EXPECT_EQ(as_written(0.15F), 0.15);
}

struct Odd {
  Shape shape = static_cast<Shape>(7);
};

TEST(ParameterTable, ADefaultBesideTheChoicesIsAProgrammersError) {
  const ParameterTable<Odd> table{parameter("shape", &Odd::shape, {{"round", Shape::round}}, "which shape")};
  EXPECT_THAT([&] { table.schema(); }, test::fails_check("one of its choices"));
}

}  // namespace
}  // namespace gibench
