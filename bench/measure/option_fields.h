/// Options as tables: each option written once, for the command line, study files and child processes.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

namespace gibench {

/// One member of `Options`. A switch is true unless its option is given; an optional number is absent unless it is given.
template <class Options>
struct OptionField {
  using Member = std::variant<std::size_t Options::*, int Options::*, std::optional<int> Options::*, std::string Options::*,
                              bool Options::*>;

  const char* option;  ///< on the command line
  const char* key;     ///< in a study file; empty: not there
  const char* meaning;
  Member member;
  std::size_t least = 0, most = 0;  ///< of a number
  bool shows_default = false;       ///< in the help
};

namespace option_text {

inline std::string of(const std::string& value) { return value; }
inline std::string of(const std::optional<int>& value) { return value ? std::to_string(*value) : std::string(); }
template <class Number>
std::string of(Number value) {
  return std::to_string(value);
}

}  // namespace option_text

/// What differs from the defaults, as it is written on the command line, option and value apart.
template <class Options>
std::vector<std::string> arguments_of(std::span<const OptionField<Options>> fields, const Options& options) {
  const Options defaults;
  std::vector<std::string> arguments;
  for (const OptionField<Options>& field : fields)
    std::visit(
        [&](auto member) {
          if (options.*member == defaults.*member) return;
          arguments.emplace_back(field.option);
          if constexpr (!std::is_same_v<decltype(member), bool Options::*>) arguments.push_back(option_text::of(options.*member));
        },
        field.member);
  return arguments;
}

}  // namespace gibench
