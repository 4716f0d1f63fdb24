/// Values between vertices, and not through walls: where another surface cuts through a triangle of the mesh, only
/// the corners on the point's own side of it count.
#pragma once

#include <cstdint>
#include <vector>

#include "common/geometry/sampling_mesh.h"
#include "common/method/task.h"

namespace gibench::spectral {

/// A mesh point with what a look at its corners needs.
class Interpolation {
 public:
  Interpolation() = default;
  /// For a scene whose surfaces do not hide one another: no edge is cut.
  explicit Interpolation(const SamplingMesh& mesh) : cut_edges_(mesh.triangles().size(), 0) {}
  /// Three occlusion rays a mesh triangle, along its edges just above it.
  Interpolation(const World& world, const SamplingMesh& mesh, Task& task);

  /// Whether the edge from corner `i` to the next is cut by a surface.
  bool edge_cut(std::uint32_t triangle, std::uint32_t i) const { return ((cut_edges_[triangle] >> i) & 1U) != 0; }
  bool torn(std::uint32_t triangle) const { return cut_edges_[triangle] != 0; }
  /// The point with only the corners that it sees, weights again with sum 1; as it was where it sees none.
  MeshPoint seen(const World& world, const SamplingMesh& mesh, MeshPoint point, const Vec3& position, RayStream& rays) const;

  std::size_t bytes() const { return cut_edges_.size(); }

 private:
  std::vector<std::uint8_t> cut_edges_;  ///< bits of the edges of every mesh triangle
};

}  // namespace gibench::spectral
