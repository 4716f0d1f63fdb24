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
  /// Occlusion rays in every mesh triangle, just above it: three along its edges, three into its corners, and from those to where
  /// their vertices are looked at from. Vertices beside a surface that cuts triangles around them get their sites in those that
  /// it does not cut. Triangles without an edge of `smallest` metres are taken to be whole.
  Interpolation(const World& world, SamplingMesh& mesh, float smallest, Task& task);

  /// Whether the edge from corner `i` to the next is cut by a surface.
  bool edge_cut(std::uint32_t triangle, std::uint32_t i) const { return ((cut_edges_[triangle] >> i) & 1U) != 0; }
  /// Whether some of its points may not see all its corners' sites.
  bool torn(std::uint32_t triangle) const { return cut_edges_[triangle] != 0; }
  std::size_t torn_triangles() const;
  /// The point with only the corners whose sites it sees, weights again with sum 1; as it was where it sees none.
  MeshPoint seen(const World& world, const SamplingMesh& mesh, MeshPoint point, const Vec3& position, RayStream& rays) const;

  std::size_t bytes() const { return cut_edges_.size() + sites_.size() * sizeof(Vec3); }

 private:
  static constexpr std::uint8_t hidden_site = 1U << 3U;  ///< no edge is cut, but a corner is cut off, or its site lies beyond
  static constexpr std::uint8_t left_out = 1U << 4U;     ///< while it is made: not looked at

  void leave_out_small(const SamplingMesh& mesh, float smallest);
  void cut_edges(const World& world, const SamplingMesh& mesh, Task& task);
  void find_sites(const World& world, const SamplingMesh& mesh);
  void find_hidden_sites(const World& world, const SamplingMesh& mesh, Task& task);
  /// Just above where a corner of a triangle takes its value from.
  Vec3 site(const SamplingMesh& mesh, std::uint32_t triangle, std::size_t corner, const Vec3& own, const Vec3& up) const;

  std::vector<std::uint8_t> cut_edges_;  ///< bits of the edges of every mesh triangle; hidden_site
  std::vector<Vec3> sites_;              ///< of every vertex with one site: where it is; of others infinity
};

}  // namespace gibench::spectral
