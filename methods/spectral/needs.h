/// The numbers that settings leave open, by what the scene needs.
#pragma once

#include <cstddef>

#include "methods/spectral/nodes.h"
#include "methods/spectral/settings.h"

namespace gibench::spectral {

/// Sets the vertices where they are left open: 8000; 16 000 of a scene of more than 32 000 triangles that clusters may stand for.
void settle_vertices(std::size_t triangles, Settings& settings);

/// Sets what else is left open: 1024 functions in parts of 1000, 1024 rays of a vertex, 1% for compression. Of
/// clusters a function for every five and a half, where that is more, parts of 500, and 2048 rays: they are many, and light from
/// a few bright places is what they gather; compression may add 2%, a small part of what else is inexact.
void settle_basis(const Nodes& nodes, Settings& settings);

}  // namespace gibench::spectral
