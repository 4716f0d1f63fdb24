#include "common/method/parameters.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "common/core/did_you_mean.h"
#include "common/core/error.h"
#include "common/core/overloaded.h"

namespace gibench {

namespace {

template <class T>
bool parse_number(const std::string& text, T& value) {
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size();
}

/// Makes `text` the value, in the type that it has; false where the text is of another type or out of range.
struct Parse {
  const ParameterSpec& spec;
  const std::string& text;

  bool operator()(bool& flag) const {
    flag = text == "true" || text == "1";
    return flag || text == "false" || text == "0";
  }
  bool operator()(std::int64_t& whole) const { return parse_number(text, whole) && in_range(static_cast<double>(whole)); }
  bool operator()(double& real) const { return parse_number(text, real) && in_range(real); }
  bool operator()(std::string& word) const {
    word = text;
    return std::find(spec.choices.begin(), spec.choices.end(), text) != spec.choices.end();
  }

 private:
  bool in_range(double number) const { return std::isfinite(number) && number >= spec.minimum && number <= spec.maximum; }
};

std::string known_parameters(const ParameterSchema& schema, const std::string& unknown) {
  std::vector<std::string> names;
  for (const ParameterSpec& spec : schema) names.push_back(spec.name);
  return names.empty() ? "it has none" : fmt::format("{}known: {}", did_you_mean(unknown, names), fmt::join(names, ", "));
}

}  // namespace

Parameters::Parameters(const ParameterSchema& schema, const std::vector<std::pair<std::string, std::string>>& settings,
                       const std::string& place) {
  for (const ParameterSpec& spec : schema) values_[spec.name] = spec.default_value;
  for (const auto& setting : settings) {
    const auto& name = setting.first;
    const auto& text = setting.second;
    const auto spec = std::find_if(schema.begin(), schema.end(), [&](const ParameterSpec& s) { return s.name == name; });
    if (spec == schema.end())
      throw InputError(place, fmt::format("unknown parameter '{}'", name), known_parameters(schema, name));
    if (!std::visit(Parse{*spec, text}, values_[name]))
      throw InputError(place, fmt::format("{}={} is not valid", name, text), "write a " + describe_type(*spec));
  }
}

const ParameterValue& Parameters::value(std::string_view name) const {
  const auto found = values_.find(name);
  GIBENCH_CHECK(found != values_.end(), "a method reads only parameters of its schema");
  return found->second;
}

std::string to_text(const ParameterValue& value) {
  return std::visit(Overloaded{[](bool flag) -> std::string { return flag ? "true" : "false"; },
                               [](std::int64_t whole) { return std::to_string(whole); },
                               [](double real) { return fmt::format("{}", real); }, [](const std::string& word) { return word; }},
                    value);
}

std::string describe_type(const ParameterSpec& spec) {
  return std::visit(
      Overloaded{[](bool) -> std::string { return "true|false"; },
                 [&](std::int64_t) { return fmt::format("whole number {:.0f}..{:.0f}", spec.minimum, spec.maximum); },
                 [&](double) { return fmt::format("real number {}..{}", spec.minimum, spec.maximum); },
                 [&](const std::string&) { return fmt::format("word, one of {}", fmt::join(spec.choices, "|")); }},
      spec.default_value);
}

}  // namespace gibench
