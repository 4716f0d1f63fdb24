#include "methods/spectral/surface_graph.h"

#include <algorithm>
#include <cmath>

namespace gibench::spectral {

namespace {

// A sliver's cotangents run to infinity either way; within these bounds the Laplacian stays positive semidefinite and its
// condition that of a mesh.
constexpr double least_cotan = 1e-4, most_cotan = 1e2;

/// One triangle's share of one edge, seen from one of its ends.
struct Share {
  std::uint32_t from, to;
  double cotan;  // infinite where the edge is cut
  bool operator<(const Share& other) const { return from != other.from ? from < other.from : to < other.to; }
};

double cotangent(const Vec3d& at, const Vec3d& b, const Vec3d& c) {
  const double sine = glm::length(glm::cross(b - at, c - at));
  return sine > 0.0 ? std::clamp(glm::dot(b - at, c - at) / sine, -most_cotan, most_cotan) : 0.0;
}

}  // namespace

SurfaceGraph make_graph(const SamplingMesh& mesh, const Interpolation& interpolation) {
  std::vector<Share> shares;
  shares.reserve(6 * mesh.triangles().size());
  const auto position = [&](std::uint32_t v) { return Vec3d(mesh.vertices()[v].position); };
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto& corners = mesh.triangles()[t].corners;
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], opposite = corners[(i + 2) % 3];
      const double half = interpolation.edge_cut(t, i) ? std::numeric_limits<double>::infinity()
                                                       : 0.5 * cotangent(position(opposite), position(a), position(b));
      shares.push_back({a, b, half});
      shares.push_back({b, a, half});
    }
  std::stable_sort(shares.begin(), shares.end());
  SurfaceGraph graph;
  for (const MeshVertex& vertex : mesh.vertices()) graph.area.push_back(static_cast<double>(vertex.area));
  graph.begin.assign(graph.size() + 1, 0);
  for (std::size_t i = 0, end = 0; i < shares.size(); i = end) {
    double sum = 0.0;
    for (; end < shares.size() && shares[end].from == shares[i].from && shares[end].to == shares[i].to; ++end)
      sum += shares[end].cotan;
    if (!std::isfinite(sum)) continue;
    graph.neighbour.push_back(shares[i].to);
    graph.cotan.push_back(std::clamp(sum, least_cotan, most_cotan));
    ++graph.begin[shares[i].from + 1];
  }
  for (std::size_t v = 0; v < graph.size(); ++v) graph.begin[v + 1] += graph.begin[v];
  return graph;
}

}  // namespace gibench::spectral
