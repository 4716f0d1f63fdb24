/// What rays say about the elements: how much of each link is free, and how much of a hemisphere is closed.
#pragma once

#include <vector>

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// Multiplies every link's factor by the share of `rays` segments between random points of both ends' cells that nothing
/// stops, and takes out the links that are wholly blocked. Points inside geometry are not drawn: areas do not hold them either.
void trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, int rays, LinkTable& links,
                 Task& task);

/// For every leaf the cosine-weighted share of its hemisphere in which lit sides of surfaces are seen, [0, 1].
std::vector<float> closed_shares(const World& world, const Elements& elements, const Hierarchy& hierarchy, int rays, Task& task);

}  // namespace gibench::antiradiance
