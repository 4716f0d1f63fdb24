/// Triangles of the mesh between whose elements another surface stands.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/geometry/sampling_mesh.h"
#include "common/method/task.h"
#include "methods/antiradiance/elements.h"

namespace gibench::antiradiance {

/// A point of a triangle of the mesh just inside one of its corners.
CellPoint corner_point(const World& world, const SamplingMesh& mesh, std::uint32_t triangle, std::size_t corner);

/// Of every triangle of the mesh whether another surface crosses the cell of one of its corners' elements, or hides two of these
/// from each other, by rays between their middles; of merged elements, which reach far, by rays along the edges whose ends are of
/// two.
std::vector<std::uint8_t> parted_triangles(const World& world, const SamplingMesh& mesh, const Elements& elements, Task& task);

}  // namespace gibench::antiradiance
