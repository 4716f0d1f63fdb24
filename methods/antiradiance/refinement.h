/// The making of links: pairs of nodes are refined until an oracle accepts them, in parallel, queue by queue.
#pragma once

#include <cstdint>

#include "common/method/task.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"
#include "methods/antiradiance/refinement_rule.h"

namespace gibench::antiradiance {

struct RefinementCounts {
  std::uint64_t pairs = 0;  ///< looked at by the oracle
  bool too_many = false;    ///< more than most_links: the table is empty
};

/// A pair that the oracle does not accept is split at the larger disc. Every receiver keeps a queue of the senders that its
/// ancestors passed on; what is to be split on its own side goes on to its two children. Receivers are worked on side by
/// side, their links come out row by row, in an order that depends on nothing else.
LinkTable make_links(const Hierarchy& hierarchy, const RefinementRule& rule, Task& task, RefinementCounts& counts);

}  // namespace gibench::antiradiance
