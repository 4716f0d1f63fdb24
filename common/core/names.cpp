#include "common/core/names.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/did_you_mean.h"

namespace gibench {

namespace {

constexpr std::size_t most_listed = 20;

}  // namespace

std::string in_quotes(std::string_view name) { return fmt::format("\"{}\"", name); }

std::string known_names(std::string_view kind, std::string_view unknown, const std::vector<std::string>& known) {
  if (known.empty()) return fmt::format("there are no {}", kind);
  const std::size_t listed = std::min(known.size(), most_listed);
  std::string text = did_you_mean(unknown, known);
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
