/// The connections between the faces of a mesh, however defective the mesh is.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/scene/scene.h"

namespace gibench {

/// For every vertex the first vertex at the same place: vertices within `tolerance` metres of it in each coordinate are one.
std::vector<std::uint32_t> weld_vertices(std::span<const Vec3> vertices, float tolerance);

/// Four units in the last place of the largest coordinate: rounding does not part what was joined, and nothing that
/// single precision tells apart by more is joined.
float weld_tolerance(std::span<const Vec3> vertices);

/// Counts over the edges of the faces (sides of triangles and quads, not the diagonals of quads) after welding. A face
/// with fewer than three different corners has no edges here. Half-edge structures (OpenMesh) cannot hold an edge of
/// more than two faces, nor two neighbours of opposite orientation, which are the things to be counted; so the edges
/// are sorted and the runs of equal ones looked at.
struct MeshTopology {
  std::size_t edges = 0;
  std::size_t boundary_edges = 0;      ///< of one face
  std::size_t non_manifold_edges = 0;  ///< of three faces or more
  std::size_t flipped_edges = 0;       ///< of two faces that run along it the same way: one of them is turned round
  std::size_t components = 0;          ///< sets of faces joined by shared edges
  bool closed = false;                 ///< there are faces, and no boundary edges

  bool oriented() const { return flipped_edges == 0; }
};

/// Faces are taken from `faces` alone; `weld` comes from weld_vertices(). O(n log n).
MeshTopology mesh_topology(std::span<const Face> faces, std::span<const std::uint32_t> weld);

/// Two neighbouring faces (indices into the faces given) across an edge of exactly two.
struct FacePair {
  std::uint32_t first, second;
};
std::vector<FacePair> neighbouring_faces(std::span<const Face> faces, std::span<const std::uint32_t> weld);

}  // namespace gibench
