#include "common/core/byte_size.h"

#include <fmt/format.h>

#include <array>

namespace gibench {

std::string byte_size(double bytes) {
  static constexpr std::array units{" B", " kB", " MB", " GB"};
  std::size_t unit = 0;
  // 999.6 would be written with four digits: it is one of the next unit.
  for (; unit + 1 < units.size() && bytes >= 999.5; ++unit) bytes /= 1000.0;
  if (unit == 0) return fmt::format("{:.0f}{}", bytes, units[unit]);
  return fmt::format("{:.{}f}{}", bytes, bytes < 9.995 ? 2 : bytes < 99.95 ? 1 : 0, units[unit]);
}

}  // namespace gibench
