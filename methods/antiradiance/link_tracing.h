/// The visibility of links by rays: how much of each is free.
#pragma once

#include <cstddef>
#include <limits>

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
  /// Links that others may be taken apart into, in all: each run of nodes has its part of them, by the links it has, and leaves
  /// links whole from there on.
  std::size_t most_made = std::numeric_limits<std::size_t>::max();
};

/// What became of the links that rays found free in part.
struct TracingCounts {
  std::size_t taken_apart = 0;
  std::size_t left_whole = 0;  ///< because of `most_made`
};

/// Multiplies every link's factor by the share of segments between random points of both ends, even by area, that nothing
/// stops, and takes out the links that are wholly blocked. Points inside geometry are not drawn: areas do not hold them either.
/// Links are from fronts to fronts. The expectation of a link, or of those made of it, is its free share: rays that decide
/// whether it is taken apart do not count for one that is not.
TracingCounts trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, const TracingRule& rule,
                          LinkTable& links, Task& task);

}  // namespace gibench::antiradiance
