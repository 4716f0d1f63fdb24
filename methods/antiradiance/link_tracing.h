/// The visibility of links by rays: how much of each is free.
#pragma once

#include <cstddef>

#include "common/method/task.h"
#include "methods/antiradiance/elements.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// How links are traced.
struct TracingRule {
  int rays = 4;       ///< a link
  bool cells = true;  ///< see refine_factors()
  /// A link with a larger factor that rays find free in part is taken apart at its larger end, down to the elements: light that
  /// a node sends through an opening is not its mean, nor does it arrive everywhere on the receiver alike.
  float most_partial = 0.0025F;
};

/// Multiplies every link's factor by the share of segments between random points of both ends, even by area, that nothing
/// stops, and takes out the links that are wholly blocked. Points inside geometry are not drawn: areas do not hold them either.
/// Links are from fronts to fronts. Returns how many links were taken apart.
std::size_t trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, const TracingRule& rule,
                        LinkTable& links, Task& task);

}  // namespace gibench::antiradiance
