#include "common/core/printable_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>

namespace gibench {

namespace {

/// Bytes of the UTF-8 character at the beginning of a text; 0 where there is none.
std::size_t length_of_character(std::string_view text) {
  const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<std::uint8_t>(text[i]) : std::uint8_t{0}; };
  const std::uint8_t first = byte(0);
  const std::size_t length = first < 0x80 ? 1 : first < 0xC2 ? 0 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 0;
  for (std::size_t i = 1; i < length; ++i)
    if ((byte(i) & 0xC0) != 0x80) return 0;
  const bool is_too_long = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xF0 && byte(1) < 0x90);
  const bool is_out_of_range = (first == 0xED && byte(1) >= 0xA0) || (first == 0xF4 && byte(1) >= 0x90);
  return is_too_long || is_out_of_range ? 0 : length;
}

/// Of Unicode: the control characters of one and of two bytes, and the marks of direction U+202A to U+202E and U+2066 to
/// U+2069.
bool is_control(std::string_view character) {
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>(character[i]); };
  switch (character.size()) {
    case 1: return byte(0) < 0x20 || byte(0) == 0x7F;
    case 2: return byte(0) == 0xC2 && byte(1) < 0xA0;
    case 3:
      return byte(0) == 0xE2 &&
             ((byte(1) == 0x80 && byte(2) >= 0xAA && byte(2) <= 0xAE) || (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9));
    default: return false;
  }
}

}  // namespace

std::string printable_text(std::string_view text) {
  std::string printable;
  while (!text.empty()) {
    const std::size_t length = length_of_character(text);
    const std::string_view character = text.substr(0, std::max<std::size_t>(1, length));
    text.remove_prefix(character.size());
    if (character == "\n" || character == "\r" || character == "\t") printable += ' ';
    else if (length > 0 && !is_control(character)) printable += character;
    else
      for (const char c : character) printable += fmt::format("\\x{:02x}", static_cast<std::uint8_t>(c));
  }
  return printable;
}

}  // namespace gibench
