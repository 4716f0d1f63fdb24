/// ICC profiles made by hand, as far as readers of pictures look at them.
#pragma once

#include <cstdint>
#include <string>

namespace gibench::test {

/// A profile of a display (version 2.1) with one tag, its description in ASCII.
inline std::string icc_profile(const std::string& description) {
  const auto number = [](std::uint32_t value) {
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(value >> shift & 0xffU);
    return bytes;
  };
  const std::string text = "desc" + number(0) + number(static_cast<std::uint32_t>(description.size() + 1)) + description + '\0';
  const std::string tag = text + std::string(3 - (text.size() + 3) % 4, '\0');  // to a multiple of four bytes
  const std::string table = number(1) + "desc" + number(128 + 16) + number(static_cast<std::uint32_t>(text.size()));
  std::string header = number(static_cast<std::uint32_t>(128 + table.size() + tag.size()));
  header += "none" + number(0x02100000) + "mntrRGB XYZ ";
  header += std::string(12, '\0') + "acsp" + std::string(28, '\0');
  header += number(0xf6d6) + number(0x10000) + number(0xd32d);  // the white D50
  return header + std::string(128 - header.size(), '\0') + table + tag;
}

}  // namespace gibench::test
