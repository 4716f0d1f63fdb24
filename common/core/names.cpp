#include "common/core/names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numeric>

namespace gibench {

namespace {

constexpr std::size_t most_listed = 20;

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

/// Levenshtein distance without regard to case.
std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, diagonal + 1});
    }
  }
  return row.back();
}

}  // namespace

std::string in_quotes(std::string_view name) { return fmt::format("\"{}\"", name); }

std::string known_names(std::string_view kind, std::string_view unknown, const std::vector<std::string>& known) {
  if (known.empty()) return fmt::format("there are no {}", kind);
  const auto distance = [&](const std::string& name) { return edit_distance(unknown, name); };
  const auto nearest =
      std::min_element(known.begin(), known.end(), [&](const auto& a, const auto& b) { return distance(a) < distance(b); });
  const bool is_near = distance(*nearest) <= std::max<std::size_t>(1, unknown.size() / 3);
  const std::size_t listed = std::min(known.size(), most_listed);
  std::string text = is_near ? fmt::format("did you mean \"{}\"? ", *nearest) : "";
  text += fmt::format("{}: {}", kind, fmt::join(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(listed), ", "));
  if (known.size() > listed) text += fmt::format(", and {} more", known.size() - listed);
  return text;
}

std::string UniqueNames::take(const std::string& name) {
  const auto [found, is_new] = times_taken_.try_emplace(name, 1);
  if (is_new) return name;
  return take(fmt::format("{}#{}", name, ++found->second));
}

}  // namespace gibench
