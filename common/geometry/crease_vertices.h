/// Vertices of a mesh split at creases: corners of faces that meet without a crease are one vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

/// The vertices after splitting, by the corners of the faces.
struct CreaseVertices {
  std::vector<std::array<std::uint32_t, 4>> of_face;  ///< the vertex at each corner; a triangle repeats its third
  std::vector<std::uint32_t> point;                   ///< of every vertex
  std::size_t refused_faces = 0;                      ///< that no two-manifold can hold beside those before them
};

/// Corners at one point are the same vertex where their faces are joined by edges across which the normals turn by no more
/// than `crease_degrees`. `normals`: unit, one per face. Half-edges by OpenMesh: a face that would make an edge or a
/// vertex non-manifold, or that is turned round against its neighbours, stands alone, with vertices of its own.
CreaseVertices crease_vertices(std::size_t points, std::span<const Face> faces, std::span<const Vec3> normals,
                               float crease_degrees);

}  // namespace gibench
