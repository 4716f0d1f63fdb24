#include "methods/meshless/transport.h"

#include <algorithm>

namespace gibench::meshless {

namespace {

constexpr std::uint32_t most_linked = 4000;  // points of more than one level

}  // namespace

std::uint32_t coarse_levels(const Hierarchy& hierarchy, const Settings& settings) {
  std::uint32_t levels = std::min(hierarchy.levels(), static_cast<std::uint32_t>(settings.bounce_levels));
  while (levels > 1 && hierarchy.level_begin(levels) > most_linked) --levels;
  return levels;
}

}  // namespace gibench::meshless
