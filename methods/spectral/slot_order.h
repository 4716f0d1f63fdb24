/// The order of nodes within the parts.
#pragma once

#include <span>

#include "methods/spectral/nodes.h"
#include "methods/spectral/partition.h"

namespace gibench::spectral {

/// Puts nodes that are close to one another next to one another in their part: it is halved across its longest side, and so
/// are the halves. Halves end where blocks of rows do (every `block` slots), so that the rows of a block are alike.
void put_neighbours_together(const Nodes& nodes, std::size_t block, Partition& partition);
/// The same of slots that need not keep to parts, in blocks of as many.
void put_neighbours_together(const Nodes& nodes, std::size_t block, std::span<const std::uint32_t> node_of_slot,
                             std::span<std::uint32_t> slots);

}  // namespace gibench::spectral
