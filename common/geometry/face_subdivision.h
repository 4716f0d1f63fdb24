/// Faces of one object cut into smaller ones, alike on both sides of every shared edge.
#pragma once

#include <cstdint>
#include <vector>

#include "common/ray/world.h"

namespace gibench {

/// The smaller faces of one object. Points are welded: a point of an edge is the same for all faces along it.
struct SubdividedObject {
  std::vector<Vec3d> points;                  ///< metres, relative to Scene::origin
  std::vector<Face> faces;                    ///< corners index into points; a triangle repeats its third corner
  std::vector<std::uint32_t> first_triangle;  ///< of every face: the scene triangle that it lies in, …
  std::vector<std::uint8_t> triangle_count;   ///< … or 2 where it lies in a quad: that triangle and the next
};

/// Cuts the faces of an object until no edge is longer than `edge_length` metres (infinity: no cuts). Planar convex quads
/// become grids of quads, opposite sides cut into equally many; all else is cut as the scene's triangles: into n² alike
/// where the sides have n pieces each, else by halving the longest side (Rivara 1984), to whatever its sides have. Vertices
/// within `weld` metres are one. Triangles of zero area give nothing.
SubdividedObject subdivide_object(const World& world, std::uint32_t object, double edge_length, float weld);

}  // namespace gibench
