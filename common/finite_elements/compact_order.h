/// Orders of points in which neighbours stand together: halved across the longest side of their box, and the halves again.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "common/core/vec.h"

namespace gibench {

/// 0, 1 or 2: of the box around the points.
template <class PositionOf>
int longest_side(std::span<const std::uint32_t> points, const PositionOf& position_of) {
  Vec3 low(std::numeric_limits<float>::infinity()), high(-std::numeric_limits<float>::infinity());
  for (const std::uint32_t point : points) {
    low = glm::min(low, position_of(point));
    high = glm::max(high, position_of(point));
  }
  const Vec3 side = high - low;
  return side.x >= side.y && side.x >= side.z ? 0 : side.y >= side.z ? 1 : 2;
}

/// Puts `points`, which stand from place `first` on, into such an order. `before(axis, a, b)`: a total order along an axis.
/// `size_of_left(size, first)`: how many of a run go to the left; 0: the run stays as it is.
template <class PositionOf, class Before, class SizeOfLeft>
void put_neighbours_together(std::span<std::uint32_t> points, std::size_t first, const PositionOf& position_of,
                             const Before& before, const SizeOfLeft& size_of_left) {
  const std::size_t left = size_of_left(points.size(), first);
  if (left == 0) return;
  const int axis = longest_side<PositionOf>(points, position_of);
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(left), points.end(),
                   [&](std::uint32_t a, std::uint32_t b) { return before(axis, a, b); });
  put_neighbours_together(points.first(left), first, position_of, before, size_of_left);
  put_neighbours_together(points.subspan(left), first + left, position_of, before, size_of_left);
}

}  // namespace gibench
