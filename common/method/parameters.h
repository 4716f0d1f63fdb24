/// The parameters of a method: a schema from which the command line, study validation and the docs are made.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace gibench {

using ParameterValue = std::variant<bool, std::int64_t, double, std::string>;

/// The default fixes the type: bool, whole number, real number, or one of `choices`.
struct ParameterSpec {
  std::string name;
  ParameterValue default_value;
  double minimum = 0.0, maximum = 0.0;  ///< inclusive range of numbers; ignored for bool and choices
  std::vector<std::string> choices;     ///< of a text parameter
  std::string meaning;                  ///< one line, with the unit
};
using ParameterSchema = std::vector<ParameterSpec>;

/// A full set of values, checked against a schema.
class Parameters {
 public:
  /// Defaults, overridden by (name, text) settings. Throws InputError for an unknown name (the known ones
  /// listed), a value of the wrong type or out of range; `place` is the option or JSON path named in the message.
  Parameters(const ParameterSchema& schema, const std::vector<std::pair<std::string, std::string>>& settings,
             const std::string& place = "--set");

  bool flag(std::string_view name) const { return get<bool>(name); }
  std::int64_t whole(std::string_view name) const { return get<std::int64_t>(name); }
  double real(std::string_view name) const { return get<double>(name); }
  const std::string& text(std::string_view name) const { return get<std::string>(name); }
  const std::map<std::string, ParameterValue, std::less<>>& values() const { return values_; }

 private:
  template <class T>
  const T& get(std::string_view name) const {
    return std::get<T>(value(name));
  }
  const ParameterValue& value(std::string_view name) const;
  std::map<std::string, ParameterValue, std::less<>> values_;
};

/// As written after `--set name=`.
std::string to_text(const ParameterValue& value);
/// The type's name and range, for lists and messages: "whole number 1..20", "real 0..1", "one of a|b", "true|false".
std::string describe_type(const ParameterSpec& spec);

}  // namespace gibench
