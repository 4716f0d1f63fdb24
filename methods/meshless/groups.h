/// Reconstruction groups: sets of surfaces between which no basis function reaches (Lehtinen et al. 2007, 6.1).
#pragma once

#include <cstdint>
#include <vector>

#include "common/ray/world.h"
#include "common/spaces/side_light.h"
#include "methods/meshless/settings.h"

namespace gibench::meshless {

/// A group for every side of every triangle of a world, which must outlive it.
struct Groups {
  const World* world = nullptr;
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_side;  ///< of a triangle's front and then its back, triangle by triangle
  std::vector<std::uint8_t> sealed;    ///< of every group: 1 where it holds the sides that no light reaches

  std::uint32_t of(std::uint32_t triangle, bool front) const { return of_side[2 * std::size_t{triangle} + (front ? 0U : 1U)]; }
  /// The group of the side that the sample lies on.
  std::uint32_t of(const SurfaceSample& sample) const {
    return of(sample.triangle, glm::dot(world->normal(sample.triangle), sample.normal) >= 0.0F);
  }
  std::size_t bytes() const { return of_side.capacity() * sizeof(std::uint32_t) + sealed.capacity(); }
};

/// Groups by Object::group and, where asked for, by connected component (components.h) and side: the back of an outer shell has
/// the normal of the inner wall's front, a wall's thickness away. `automatic` keeps the `most_own_groups` such groups of the
/// largest area for themselves; the others of an Object::group and side are one group together, so that one more small component
/// changes no group but that. With `light`, the sides that none of it reaches are apart from the others, one group of each
/// Object::group and side: lit and sealed fronts may lie beside each other, as in a window that is set into a wall.
Groups make_groups(const World& world, Grouping grouping, const SideLight* light = nullptr);

inline constexpr std::uint32_t most_own_groups = 32;

}  // namespace gibench::meshless
