/// The test whether a quad can be cut by a bilinear map: flat, and turning the same way at every corner.
#pragma once

#include <array>
#include <cmath>

#include "common/core/vec.h"

namespace gibench {

/// `Number`: float or double, in which it is decided. False for a quad without area.
template <class Number>
bool is_planar_and_convex(const std::array<glm::vec<3, Number>, 4>& p) {
  constexpr auto planarity = static_cast<Number>(1e-5);   // of the diagonals
  constexpr auto least_turn = static_cast<Number>(1e-3);  // sine of the angle at a corner
  const auto first = p[2] - p[0], second = p[3] - p[1], axis = glm::cross(first, second);
  const Number doubled_area = glm::length(axis);
  if (!(doubled_area > Number{0})) return false;
  const auto normal = axis / doubled_area;
  if (std::fabs(glm::dot(p[1] - p[0], normal)) > planarity * (glm::length(first) + glm::length(second))) return false;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto before = p[i] - p[(i + 3) % 4], after = p[(i + 1) % 4] - p[i];
    if (!(glm::dot(glm::cross(before, after), normal) > least_turn * glm::length(before) * glm::length(after))) return false;
  }
  return true;
}

}  // namespace gibench
