/// The order of nodes within the parts.
#pragma once

#include "methods/spectral/nodes.h"
#include "methods/spectral/partition.h"

namespace gibench::spectral {

/// Puts nodes that are close to one another next to one another in their part: it is halved across its longest side, and so
/// are the halves. Halves end where blocks of rows do (every `block` slots), so that the rows of a block are alike.
void put_neighbours_together(const Nodes& nodes, std::size_t block, Partition& partition);

}  // namespace gibench::spectral
