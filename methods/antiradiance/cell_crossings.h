/// Surfaces that cross the cells of elements: which points of a cell see one another past them.
#pragma once

#include <cstdint>
#include <span>

#include "common/ray/ray_stream.h"
#include "common/ray/world.h"
#include "methods/antiradiance/cell_point.h"

namespace gibench::antiradiance {

/// Whether no surface stands between two points of one surface: none but `faces` (scene faces that they lie on) and what runs
/// along with them. Of points whose normals differ nothing is known, and nothing is assumed to stand between them.
bool nothing_between(const World& world, const CellPoint& from, const CellPoint& to, std::span<const std::uint32_t> faces,
                     RayStream& rays);

/// Takes out of a cell (as not exposed) the points that no chain of free segments joins to its vertex: those that another
/// surface parts from it. `beside_vertex`: points just beside the vertex, the first of which that sees any point of the cell
/// stands for it; where none does, the point nearest to them counts. Returns whether there were any.
bool part_cell(const World& world, std::span<CellPoint> points, std::span<const CellPoint> beside_vertex,
               std::span<const std::uint32_t> faces, RayStream& rays);

/// Whether another surface lies behind some point of the cell, nearer than `distance` metres.
bool backed_within(std::span<const CellPoint> points, float distance, RayStream& rays);

}  // namespace gibench::antiradiance
