#include "common/image/icc_profile.h"

#include <algorithm>

#include "common/image/byte_reader.h"

namespace gibench {

namespace {

constexpr std::size_t header_bytes = 128, entry_bytes = 12;

std::string_view part(std::string_view bytes, std::size_t begin, std::size_t size) {
  return begin < bytes.size() ? bytes.substr(begin, size) : std::string_view();
}

std::string_view description_tag(std::string_view profile) {
  const std::size_t most = profile.size() / entry_bytes;
  const std::size_t count = std::min<std::size_t>(most, big_endian(profile, header_bytes));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string_view entry = part(profile, header_bytes + 4 + i * entry_bytes, entry_bytes);
    if (entry.starts_with("desc")) return part(profile, big_endian(entry, 4), big_endian(entry, 8));
  }
  return {};
}

/// Latin letters of UTF-16; others become question marks.
std::string latin(std::string_view text) {
  std::string letters;
  for (std::size_t i = 0; i + 1 < text.size(); i += 2) letters += text[i] == '\0' ? text[i + 1] : '?';
  return letters;
}

}  // namespace

std::string description_of_profile(std::string_view profile) {
  const std::string_view tag = description_tag(profile);
  if (tag.starts_with("mluc")) return latin(part(tag, big_endian(tag, 24), big_endian(tag, 20)));  // of its first language
  if (!tag.starts_with("desc")) return {};
  const std::string_view text = part(tag, 12, big_endian(tag, 8));
  return std::string(text.substr(0, text.find('\0')));
}

}  // namespace gibench
