/// Polygons of more than four corners to triangles.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"

namespace gibench {

/// Corner indices of n - 2 triangles that cover a simple polygon of n ≥ 3 corners, convex or not, all turning the way
/// the polygon does (ear clipping in the plane of its vector area; Meisters 1975). A crossed or degenerate
/// polygon gives n - 2 triangles too, which then overlap or have no area. Assimp 5.2 has a triangulation of its own,
/// which covers some concave polygons wrongly (Assimp issues 1136, 3019, 3609).
std::vector<std::array<std::uint32_t, 3>> triangulate_polygon(std::span<const Vec3d> corners);

}  // namespace gibench
