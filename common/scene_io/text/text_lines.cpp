#include "common/scene_io/text/text_lines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <iterator>
#include <limits>

#include "common/core/names.h"

namespace gibench {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\f' || c == '\v' || c == '\n'; }

}  // namespace

TextLines::TextLines(std::string_view text)
    : rest_(text), line_end_(text.find('\n') == std::string_view::npos ? '\r' : '\n') {}  // '\r' on old Macintoshes

std::string_view TextLines::take_line() {
  const auto end = rest_.find(line_end_);
  is_unended_ = end == std::string_view::npos;
  const std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(is_unended_ ? rest_.size() : end + 1);
  ++lines_taken_;
  return trimmed(line);
}

bool TextLines::next() {
  while (!rest_.empty()) {
    number_ = lines_taken_ + 1;
    line_ = take_line();
    if (line_.starts_with('#')) continue;
    if (line_.ends_with('\\')) {
      joined_.clear();
      while (line_.ends_with('\\')) {
        joined_.append(line_.substr(0, line_.size() - 1)).append(" ");
        line_ = rest_.empty() ? std::string_view() : take_line();
      }
      joined_.append(line_);
      line_ = trimmed(joined_);
    }
    if (!line_.empty()) return true;
  }
  return false;
}

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

std::string_view take_word(std::string_view& line) {
  std::size_t length = 0;
  while (length < line.size() && !is_blank(line[length])) ++length;
  const std::string_view word = line.substr(0, length);
  while (length < line.size() && is_blank(line[length])) ++length;
  line.remove_prefix(length);
  return word;
}

std::optional<double> to_number(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (at != end || error == std::errc::invalid_argument) return std::nullopt;
  if (error == std::errc::result_out_of_range) {
    const bool is_tiny = word.find("e-") != std::string_view::npos || word.find("E-") != std::string_view::npos ||
                         word.find_first_of("eE") == std::string_view::npos;
    return is_tiny ? 0.0 : (word.starts_with('-') ? -1.0 : 1.0) * std::numeric_limits<double>::infinity();
  }
  return value;
}

std::string lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

std::string excerpt(std::string_view text) {
  constexpr std::size_t longest = 60;  // characters
  return text.size() <= longest ? in_quotes(text) : in_quotes(std::string(text.substr(0, longest)) + "…");
}

std::string few_of(const std::set<std::string>& names) {
  constexpr std::size_t most = 10;
  const auto end = std::next(names.begin(), static_cast<std::ptrdiff_t>(std::min(most, names.size())));
  std::string text = fmt::format("{}", fmt::join(names.begin(), end, ", "));
  if (names.size() > most) text += fmt::format(", and {} more", names.size() - most);
  return text;
}

}  // namespace gibench
