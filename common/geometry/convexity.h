/// The test whether a mesh bounds a convex set.
#pragma once

#include <cstdint>
#include <span>

#include "common/scene/scene.h"

namespace gibench {

/// Whether all vertices lie on one side of the plane of every face, the same side for all faces (behind their fronts: an
/// object; before them: a room), up to `tolerance` metres. Says nothing about closedness. Degenerate triangles are left
/// out; false where there are no others.
///
/// Up to 10^8 pairs of faces and vertices all are looked at. Beyond that each face is tested against its neighbours
/// and against the extreme vertices in 128 directions spread over the sphere, which finds every dent (a neighbour lies
/// before it) and every fold back that is larger than the spacing of the directions.
bool bounds_convex_set(std::span<const Vec3> vertices, std::span<const Triangle> triangles, std::span<const std::uint32_t> weld,
                       float tolerance);

}  // namespace gibench
