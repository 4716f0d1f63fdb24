/// The order of vertices within the parts.
#pragma once

#include "common/geometry/sampling_mesh.h"
#include "methods/spectral/partition.h"

namespace gibench::spectral {

/// Puts vertices that are close to one another next to one another in their part: it is halved across its longest side, and so
/// are the halves. Halves end where blocks of rows do (every `block` slots), so that the rows of a block are alike.
void put_neighbours_together(const SamplingMesh& mesh, std::size_t block, Partition& partition);

}  // namespace gibench::spectral
