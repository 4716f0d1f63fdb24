#include "common/method/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/core/error.h"

namespace gibench {

namespace {

template <class T>
bool parse_number(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// The value that `text` stands for, in the type of the spec's default; nullopt-like empty result is `false`.
bool parse_value(const ParameterSpec& spec, const std::string& text, ParameterValue& value) {
  const auto in_range = [&](double number) { return std::isfinite(number) && number >= spec.minimum && number <= spec.maximum; };
  if (std::holds_alternative<bool>(spec.default_value)) {
    value = text == "true" || text == "1";
    return text == "true" || text == "false" || text == "1" || text == "0";
  }
  if (std::int64_t whole = 0; std::holds_alternative<std::int64_t>(spec.default_value)) {
    if (!parse_number(text, whole) || !in_range(static_cast<double>(whole))) return false;
    value = whole;
    return true;
  }
  if (double real = 0.0; std::holds_alternative<double>(spec.default_value)) {
    if (!parse_number(text, real) || !in_range(real)) return false;
    value = real;
    return true;
  }
  value = text;
  return std::find(spec.choices.begin(), spec.choices.end(), text) != spec.choices.end();
}

std::string known_names(const ParameterSchema& schema) {
  std::vector<std::string> names;
  for (const ParameterSpec& spec : schema) names.push_back(spec.name);
  return names.empty() ? "it has none" : fmt::format("known: {}", fmt::join(names, ", "));
}

}  // namespace

Parameters::Parameters(const ParameterSchema& schema, const std::vector<std::pair<std::string, std::string>>& settings,
                       const std::string& place) {
  for (const ParameterSpec& spec : schema) values_[spec.name] = spec.default_value;
  for (const auto& setting : settings) {
    const auto& name = setting.first;
    const auto& text = setting.second;
    const auto spec = std::find_if(schema.begin(), schema.end(), [&](const ParameterSpec& s) { return s.name == name; });
    if (spec == schema.end()) throw InputError(place, fmt::format("unknown parameter '{}'", name), known_names(schema));
    if (!parse_value(*spec, text, values_[name]))
      throw InputError(place, fmt::format("{}={} is not valid", name, text), "write a " + describe_type(*spec));
  }
}

const ParameterValue& Parameters::value(std::string_view name) const {
  const auto found = values_.find(name);
  GIBENCH_CHECK(found != values_.end(), "a method reads only parameters of its schema");
  return found->second;
}

std::string to_text(const ParameterValue& value) {
  if (const bool* flag = std::get_if<bool>(&value)) return *flag ? "true" : "false";
  if (const std::int64_t* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  if (const double* real = std::get_if<double>(&value)) return fmt::format("{}", *real);
  return std::get<std::string>(value);
}

std::string describe_type(const ParameterSpec& spec) {
  if (std::holds_alternative<bool>(spec.default_value)) return "true|false";
  if (std::holds_alternative<std::int64_t>(spec.default_value))
    return fmt::format("whole number {:.0f}..{:.0f}", spec.minimum, spec.maximum);
  if (std::holds_alternative<double>(spec.default_value)) return fmt::format("real number {}..{}", spec.minimum, spec.maximum);
  return fmt::format("word, one of {}", fmt::join(spec.choices, "|"));
}

}  // namespace gibench
