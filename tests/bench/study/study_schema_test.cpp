/// The schema of study files and the tables of options say the same.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "bench/measure/measuring_fields.h"
#include "bench/measure/relight_options.h"
#include "bench/measure/seed_answers.h"
#include "bench/study/study_file.h"

namespace gibench {
namespace {

using nlohmann::json;

json schema() { return json::parse(study_schema_text()); }

/// A member's type in JSON Schema, and whether it leaves an option out by a value of its own.
struct SchemaType {
  const char* name;
  bool is_off_at_zero = false;
};
template <class Options>
SchemaType type_of(std::size_t Options::*member) {
  return {"integer", Options().*member == 0};
}
template <class Options>
SchemaType type_of(int Options::*member) {
  return {"integer", Options().*member == 0};
}
template <class Options>
SchemaType type_of(std::optional<int> Options::*) {
  return {"integer"};
}
template <class Options>
SchemaType type_of(std::string Options::*) {
  return {"string"};
}
template <class Options>
SchemaType type_of(bool Options::*) {
  return {"boolean"};
}

/// Each field that a study may give has a property of its name, type and range.
template <class Options>
void expect_agreement(const json& properties, std::span<const OptionField<Options>> fields) {
  for (const OptionField<Options>& field : fields) {
    if (*field.key == '\0') continue;
    ASSERT_TRUE(properties.contains(field.key)) << field.key;
    const json& property = properties[field.key];
    const SchemaType type = std::visit([](auto member) { return type_of(member); }, field.member);
    EXPECT_EQ(property["type"], type.name) << field.key;
    EXPECT_EQ(property.contains("maximum"), property["type"] == "integer") << field.key;
    if (property["type"] != "integer") continue;
    // Where 0 stands for no such number on the command line, a study leaves the key out.
    const std::size_t least = field.least == 0 && type.is_off_at_zero ? 1 : field.least;
    EXPECT_EQ(property["minimum"].get<std::size_t>(), least) << field.key;
    EXPECT_EQ(property["maximum"].get<std::size_t>(), field.most) << field.key;
  }
}

/// The properties that no table of options holds are read one by one.
template <class Options>
void expect_no_others(const json& properties, std::span<const OptionField<Options>> fields, const std::set<std::string>& others) {
  std::set<std::string> known = others;
  for (const OptionField<Options>& field : fields) known.insert(field.key);
  for (const auto& [name, property] : properties.items()) EXPECT_TRUE(known.contains(name)) << name;
}

TEST(StudySchema, AgreesWithTheMeasuringOptions) {
  const json properties = schema()["properties"];
  expect_agreement(properties, measuring_fields());
  expect_no_others(properties, measuring_fields(),
                   {"$schema", "gibench_study", "name", "description", "scenes", "methods", "relights", "reference", "tolerance",
                    "method_seeds", "time_limit_seconds", "memory_limit_mb"});
  EXPECT_EQ(properties["method_seeds"]["maximum"], most_method_seeds);
}

TEST(StudySchema, AgreesWithTheOptionsOfRelightings) {
  const json properties = schema()["definitions"]["relight"]["properties"];
  expect_agreement(properties, relight_fields());
  expect_no_others(properties, relight_fields(), {"scene", "lights", "method", "preset", "label", "parameters"});
}

}  // namespace
}  // namespace gibench
