#include "methods/spectral/surface_graph.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// The shares that run between different nodes.
std::vector<Share> crossing_shares(const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes) {
  std::vector<Share> shares;
  shares.reserve(6 * std::min<std::size_t>(mesh.triangles().size(), 4 * std::size_t{nodes.size()}));
  const auto position = [&](std::uint32_t v) { return Vec3d(mesh.vertices()[v].position); };
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
    for (std::uint32_t i = 0; i < 3; ++i) {
      const auto& corners = mesh.triangles()[t].corners;
      const std::uint32_t a = corners[i], b = corners[(i + 1) % 3], opposite = corners[(i + 2) % 3];
      const std::uint32_t from = nodes.of_vertex(a), to = nodes.of_vertex(b);
      if (from == to) continue;
      double half = std::numeric_limits<double>::infinity();
      if (!interpolation.edge_cut(t, i)) {
        half = 0.5 * cotangent(position(opposite), position(a), position(b));
        if (!nodes.is_single(from) || !nodes.is_single(to)) {
          const double distance = glm::length(Vec3d(nodes[from].position) - Vec3d(nodes[to].position));
          half *= distance > 0.0 ? glm::length(position(a) - position(b)) / distance : 1.0;
        }
      }
      shares.push_back({from, to, half});
      shares.push_back({to, from, half});
    }
  std::stable_sort(shares.begin(), shares.end());
  return shares;
}

}  // namespace

SurfaceGraph make_graph(const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes) {
  const std::vector<Share> shares = crossing_shares(mesh, interpolation, nodes);
  SurfaceGraph graph;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) graph.area.push_back(static_cast<double>(nodes[node].area));
  graph.begin.assign(graph.size() + 1, 0);
  for (std::size_t i = 0, end = 0; i < shares.size(); i = end) {
    double sum = 0.0;
    std::size_t uncut = 0;
    for (; end < shares.size() && shares[end].from == shares[i].from && shares[end].to == shares[i].to; ++end)
      if (std::isfinite(shares[end].cotan)) sum += shares[end].cotan, ++uncut;
    const bool single = nodes.is_single(shares[i].from) && nodes.is_single(shares[i].to);
    if (uncut == 0 || (single && uncut < end - i)) continue;
    graph.neighbour.push_back(shares[i].to);
    graph.cotan.push_back(std::clamp(sum, least_cotan, most_cotan));
    ++graph.begin[shares[i].from + 1];
  }
  for (std::size_t v = 0; v < graph.size(); ++v) graph.begin[v + 1] += graph.begin[v];
  return graph;
}

void SurfaceGraph::add(std::span<const AddedEdge> edges) {
  std::vector<Share> shares;
  for (std::uint32_t node = 0; node < size(); ++node)
    for (std::uint32_t e = begin[node]; e < begin[node + 1]; ++e) shares.push_back({node, neighbour[e], cotan[e]});
  for (const AddedEdge& edge : edges) {
    shares.push_back({edge.from, edge.to, edge.cotan});
    shares.push_back({edge.to, edge.from, edge.cotan});
  }
  std::stable_sort(shares.begin(), shares.end());
  begin.assign(size() + 1, 0);
  neighbour.clear();
  cotan.clear();
  for (const Share& share : shares) {
    neighbour.push_back(share.to);
    cotan.push_back(share.cotan);
    ++begin[share.from + 1];
  }
  for (std::size_t v = 0; v < size(); ++v) begin[v + 1] += begin[v];
}

Pieces connected_pieces(const SurfaceGraph& graph, std::span<const std::uint32_t> label) {
  constexpr std::uint32_t none = 0xffffffffU;
  Pieces pieces{std::vector<std::uint32_t>(graph.size(), none)};
  std::vector<std::uint32_t> front;
  for (std::uint32_t start = 0; start < graph.size(); ++start) {
    if (pieces.of_node[start] != none) continue;
    pieces.of_node[start] = pieces.count;
    front.assign(1, start);
    while (!front.empty()) {
      const std::uint32_t v = front.back();
      front.pop_back();
      for (const std::uint32_t other : graph.neighbours(v)) {
        if (pieces.of_node[other] != none || label[other] != label[v]) continue;
        pieces.of_node[other] = pieces.count;
        front.push_back(other);
      }
    }
    ++pieces.count;
  }
  return pieces;
}

}  // namespace gibench::spectral
