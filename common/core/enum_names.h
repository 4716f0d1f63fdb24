/// Enumerators by their names, for enums that list all of theirs and have a to_string.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace gibench {

/// The one of `all` with this name; empty where there is none.
template <class All>
auto find_named(const All& all, std::string_view name) -> std::optional<typename All::value_type> {
  for (const auto& each : all)
    if (name == to_string(each)) return each;
  return std::nullopt;
}

/// "direct, indirect, total"
template <class All>
std::string list_names(const All& all) {
  std::string names;
  for (const auto& each : all) names += (names.empty() ? "" : ", ") + std::string(to_string(each));
  return names;
}

}  // namespace gibench
