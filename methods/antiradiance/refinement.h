/// Makes the links: pairs of nodes are refined until an oracle accepts them, in parallel, queue by queue.
#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "common/method/task.h"
#include "methods/antiradiance/hierarchy.h"
#include "methods/antiradiance/links.h"

namespace gibench::antiradiance {

/// Which sides exchange light.
enum class Facing {
  fronts,  ///< fronts send to fronts: real light
  both,    ///< backs send, too (antiradiance), and black backs receive
};

struct RefinementRule {
  Facing facing = Facing::fronts;
  /// The oracle accepts a pair when neither disc fills more than this share of the other's hemisphere (weighted by the cosines).
  float tolerance = 0.01F;
  /// Radiosity of every node, W/m²; then what is held against the tolerance is form factor · radiosity · area over the mean of
  /// radiosity and the mean area of the elements. Empty: the geometry alone.
  std::span<const float> radiosity = {};
  float mean_radiosity = 0.0F;
  std::size_t most_links = std::numeric_limits<std::size_t>::max();
};

struct RefinementCounts {
  std::uint64_t pairs = 0;  ///< looked at by the oracle
  bool too_many = false;    ///< more than most_links: the table is empty
};

/// A pair that the oracle does not accept is split at the larger disc. Every receiver keeps a queue of the senders that its
/// ancestors passed on; what is to be split on its own side goes on to its two children. Receivers are worked on side by
/// side, their links come out row by row, in an order that depends on nothing else.
LinkTable make_links(const Hierarchy& hierarchy, const RefinementRule& rule, Task& task, RefinementCounts& counts);

}  // namespace gibench::antiradiance
