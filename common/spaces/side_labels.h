/// Labels of the sides of triangles, by object group, side and lit space: what clusters and joins keep apart.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/ray/world.h"
#include "common/spaces/side_light.h"

namespace gibench {

/// Numbers from 0 to count − 1. Two sides have the same label where their objects are of one `group`, both are fronts or both are
/// backs, and light reaches both or neither.
class SideLabels {
 public:
  static constexpr std::uint32_t none = 0xffffffffU;

  SideLabels(const World& world, const SideLight& light);

  /// none of a black side and of a triangle without area.
  std::uint32_t of(std::uint32_t triangle, bool front) const { return labels_[SideCells::side_number(triangle, front)]; }
  std::uint32_t count() const { return static_cast<std::uint32_t>(reached_.size()); }
  /// Whether light reaches the sides of a label.
  bool is_reached(std::uint32_t label) const { return reached_[label] != 0; }
  std::size_t bytes() const { return labels_.capacity() * sizeof(std::uint32_t) + reached_.capacity(); }

 private:
  std::vector<std::uint32_t> labels_;  ///< of every side, by SideCells::side_number()
  std::vector<std::uint8_t> reached_;  ///< of every label
};

}  // namespace gibench
