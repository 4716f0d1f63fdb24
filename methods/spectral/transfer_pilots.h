/// Rows of the transfer matrices that are made first, whole, to choose from them what the others may leave out.
#pragma once

#include <vector>

#include "methods/spectral/compression.h"
#include "methods/spectral/transfer.h"
#include "methods/spectral/vertex_rays.h"

namespace gibench::spectral {

/// Evenly spread blocks of rows of T^s by the matrix's own rays, and each twice again by fewer, independent ones. Those of a run
/// that is cancelled may have no rows.
std::vector<PilotBlock> pilot_rows(const World& world, const Transfer& transfer, const VertexRays& rays, int ray_count,
                                   Task& task);

/// The same of the harmonic slices: for each of fewer blocks of glossy vertices, one pilot for every slice.
std::vector<PilotBlock> glossy_pilot_rows(const World& world, const Transfer& transfer, const VertexRays& rays, int ray_count,
                                          Task& task);

}  // namespace gibench::spectral
