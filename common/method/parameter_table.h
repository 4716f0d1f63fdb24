/// The parameters of a method, each bound to one member of its settings: schema, defaults and reading follow from one table.
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <type_traits>
#include <vector>

#include "common/core/error.h"
#include "common/method/parameters.h"

namespace gibench {

/// One row of the table. The default is what the member is initialised with, and is written nowhere else.
template <class Settings>
struct BoundParameter {
  ParameterSpec spec;  ///< all but the default
  std::function<ParameterValue(const Settings&)> written;
  std::function<void(const Parameters&, Settings&)> read;
};

/// A word and what it stands for.
template <class Value>
struct Choice {
  const char* word;
  Value value;
};

/// The real number that is written as `value` is: 0.01 for 0.01F, not 0.00999999977648.
double as_written(float value);

/// true or false
template <class Settings>
BoundParameter<Settings> parameter(const char* name, bool Settings::*member, const char* meaning) {
  return {{name, {}, 0.0, 0.0, {}, meaning},
          [member](const Settings& settings) { return ParameterValue(settings.*member); },
          [member, name](const Parameters& from, Settings& settings) { settings.*member = from.flag(name); }};
}

/// A whole number where the member is one, else a real number: from `least` to `most`, both included.
template <class Settings, class Number>
BoundParameter<Settings> parameter(const char* name, Number Settings::*member, double least, double most, const char* meaning) {
  static_assert(std::is_arithmetic_v<Number> && !std::is_same_v<Number, bool>);
  BoundParameter<Settings> row{{name, {}, least, most, {}, meaning}, {}, {}};
  row.written = [member](const Settings& settings) -> ParameterValue {
    if constexpr (std::is_integral_v<Number>) return static_cast<std::int64_t>(settings.*member);
    else if constexpr (std::is_same_v<Number, float>) return as_written(settings.*member);
    else return settings.*member;
  };
  row.read = [member, name](const Parameters& from, Settings& settings) {
    if constexpr (std::is_integral_v<Number>) settings.*member = static_cast<Number>(from.whole(name));
    else settings.*member = static_cast<Number>(from.real(name));
  };
  return row;
}

/// One of some words, which stand for values of the member.
template <class Settings, class Value>
BoundParameter<Settings> parameter(const char* name, Value Settings::*member,
                                   std::initializer_list<Choice<std::type_identity_t<Value>>> choices, const char* meaning) {
  const std::vector<Choice<Value>> known(choices);
  BoundParameter<Settings> row{{name, {}, 0.0, 0.0, {}, meaning}, {}, {}};
  for (const Choice<Value>& choice : known) row.spec.choices.emplace_back(choice.word);
  row.written = [member, known](const Settings& settings) -> ParameterValue {
    for (const Choice<Value>& choice : known)
      if (choice.value == settings.*member) return std::string(choice.word);
    GIBENCH_CHECK(false, "the default of a parameter is one of its choices");
  };
  row.read = [member, known, name](const Parameters& from, Settings& settings) {
    for (const Choice<Value>& choice : known)
      if (choice.word == from.text(name)) settings.*member = choice.value;
  };
  return row;
}

/// All parameters of a method, one row each.
template <class Settings>
class ParameterTable {
 public:
  ParameterTable(std::initializer_list<BoundParameter<Settings>> rows) : rows_(rows) {}

  /// In the order of the rows; the defaults are those of default-constructed settings.
  ParameterSchema schema() const {
    const Settings defaults;
    ParameterSchema schema;
    for (const BoundParameter<Settings>& row : rows_) {
      schema.push_back(row.spec);
      schema.back().default_value = row.written(defaults);
    }
    return schema;
  }

  Settings read(const Parameters& parameters) const {
    Settings settings;
    for (const BoundParameter<Settings>& row : rows_) row.read(parameters, settings);
    return settings;
  }

 private:
  std::vector<BoundParameter<Settings>> rows_;
};

}  // namespace gibench
