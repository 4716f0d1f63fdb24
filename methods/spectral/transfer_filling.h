/// The filling of the transfer matrices, row by row, by rays from every vertex.
#pragma once

#include "methods/spectral/transfer.h"
#include "methods/spectral/vertex_rays.h"

namespace gibench::spectral {

/// What is left out of the matrices.
struct Truncations {
  Truncation irradiance, slices;
};

/// The matrix of one bounce, and the harmonic slices where the transfer has glossy slots.
void fill_matrices(const World& world, const VertexRays& rays, const Truncations& truncations, Transfer& transfer, Task& task);

}  // namespace gibench::spectral
