/// Places where a basis function reaches past another surface, so that light is taken from its other side.
#pragma once

#include <cstdint>
#include <span>

#include "common/method/task.h"
#include "methods/meshless/expansion.h"
#include "methods/meshless/groups.h"

namespace gibench::meshless {

/// Places that were looked at, and those of them that cannot see the point of a function that the value there is made of.
struct Crossings {
  std::uint64_t tried = 0, crossed = 0;
};

/// Looks at every n-th of the samples, at most a thousand or so, and there at the finest functions that add to the value: coarser
/// ones may reach further, and are corrected by those. An occlusion ray each, just above the surface.
Crossings find_crossings(const World& world, const Groups& groups, const Expansion& expansion,
                         std::span<const SurfaceSample> samples, Task& task);

}  // namespace gibench::meshless
