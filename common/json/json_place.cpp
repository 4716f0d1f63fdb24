#include "common/json/json_place.h"

#include <fmt/format.h>

#include <cctype>

namespace gibench {

namespace {

bool is_plain_word(std::string_view key) {
  if (key.empty() || std::isdigit(static_cast<unsigned char>(key.front())) != 0) return false;
  for (const char c : key)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '_' && c != '-') return false;
  return true;
}

}  // namespace

JsonPlace JsonPlace::operator[](std::string_view key) const {
  JsonPlace place = *this;
  place.text_ += is_plain_word(key) ? fmt::format(".{}", key) : fmt::format("[\"{}\"]", key);
  return place;
}

JsonPlace JsonPlace::operator[](std::size_t index) const {
  JsonPlace place = *this;
  place.text_ += fmt::format("[{}]", index);
  return place;
}

}  // namespace gibench
