/// Faces of any number of corners as triangles and quads.
#pragma once

#include <cstdint>
#include <span>

#include "common/scene/scene_assembler.h"

namespace gibench {

/// Corners a face may have: triangulating costs the square of them.
inline constexpr std::size_t most_corners = 10000;

/// Adds a face of 3 to most_corners corners, which index into the geometry's vertices: triangles and quads as they are,
/// larger polygons as triangles.
void add_face(std::span<const std::uint32_t> corners, ObjectGeometry& geometry);

}  // namespace gibench
