/// The surroundings of elements by rays: how much of each hemisphere is closed, and which elements are in one space.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"

namespace gibench::antiradiance {

/// What rays from every element find around it.
struct Surroundings {
  std::vector<float> closed;         ///< cosine-weighted share of the hemisphere in which lit sides are seen, [0, 1]
  std::vector<std::uint32_t> space;  ///< elements between which no chain of rays leads are in different spaces: nothing that
                                     ///< happens in one is of any account in the other
};
/// How it is looked around.
struct LookRule {
  int rays = 0;  ///< of every element
  /// Whether what sees the black back of a surface is in one space with what its front sees: with negative light, which leaves
  /// the front for light that arrives at the back.
  bool over_black_backs = false;
  std::span<const std::uint8_t> parted_triangles = {};  ///< see parted_triangles.h: spaces only touch there; empty: none
  bool is_parted(std::size_t triangle) const { return !parted_triangles.empty() && parted_triangles[triangle] != 0; }
};
Surroundings look_around(const World& world, const SamplingMesh& mesh, const Elements& elements, const LookRule& rule,
                         Task& task);

}  // namespace gibench::antiradiance
