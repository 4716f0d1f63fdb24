/// Reconstruction groups: sets of objects between which no basis function reaches (Lehtinen et al. 2007, 6.1).
#pragma once

#include <cstdint>
#include <vector>

#include "common/ray/world.h"
#include "methods/meshless/settings.h"

namespace gibench::meshless {

struct Groups {
  std::uint32_t count = 0;
  std::vector<std::uint32_t> of_triangle;  ///< group of every triangle of the scene
  std::size_t bytes() const { return of_triangle.capacity() * sizeof(std::uint32_t); }
};

/// Groups by Object::group and, where asked for, by connected component (components.h). `automatic` keeps the `most_own_groups`
/// components of the largest area for themselves; the others of an Object::group are one group together, so that one more small
/// component changes no group but that.
Groups make_groups(const World& world, Grouping grouping);

inline constexpr std::uint32_t most_own_groups = 32;

}  // namespace gibench::meshless
