/// Visibility of elements by rays: how much of each link is free, and how much of a hemisphere is closed.
#pragma once

#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// Multiplies every link's factor by the share of `rays` segments between random points of both ends, even by area, that nothing
/// stops, and takes out the links that are wholly blocked. Points inside geometry are not drawn: areas do not hold them either.
void trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, int rays, LinkTable& links,
                 Task& task);

/// What rays from every element find around it.
struct Surroundings {
  std::vector<float> closed;         ///< cosine-weighted share of the hemisphere in which lit sides are seen, [0, 1]
  std::vector<std::uint32_t> space;  ///< elements between which no chain of rays leads are in different spaces: nothing that
                                     ///< happens in one is of any account in the other
};
Surroundings look_around(const World& world, const SamplingMesh& mesh, const Elements& elements, int rays, Task& task);

}  // namespace gibench::antiradiance
