#include "common/geometry/mesh_topology.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace gibench {

namespace {

/// An edge of one face: its ends, smaller first, and whether the face runs from the larger to the smaller.
struct FaceEdge {
  std::uint64_t ends;
  std::uint32_t face;
  bool backward;
};

std::vector<FaceEdge> sorted_edges(std::span<const Face> faces, std::span<const std::uint32_t> weld) {
  std::vector<FaceEdge> edges;
  edges.reserve(4 * faces.size());
  for (std::uint32_t f = 0; f < faces.size(); ++f) {
    std::array<std::uint32_t, 4> corners{};
    std::size_t count = 0;  // of corners that differ from their neighbours
    for (const std::uint32_t corner : faces[f].corners)
      if (count == 0 || weld[corner] != corners[count - 1]) corners[count++] = weld[corner];
    while (count > 1 && corners[count - 1] == corners[0]) --count;
    if (count < 3) continue;
    for (std::size_t i = 0; i < count; ++i) {
      const std::uint32_t from = corners[i], to = corners[(i + 1) % count];
      edges.push_back({(std::uint64_t{std::min(from, to)} << 32U) | std::max(from, to), f, from > to});
    }
  }
  std::sort(edges.begin(), edges.end(),
            [](const FaceEdge& a, const FaceEdge& b) { return a.ends != b.ends ? a.ends < b.ends : a.face < b.face; });
  return edges;
}

/// Calls visit(faces of one edge) for every edge.
template <class Visit>
void for_each_edge(const std::vector<FaceEdge>& edges, const Visit& visit) {
  for (std::size_t begin = 0, end = 0; begin < edges.size(); begin = end) {
    while (end < edges.size() && edges[end].ends == edges[begin].ends) ++end;
    visit(std::span<const FaceEdge>(edges).subspan(begin, end - begin));
  }
}

/// Disjoint sets with path halving.
class Sets {
 public:
  explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t a, std::uint32_t b) { parent_[root(a)] = root(b); }

 private:
  std::vector<std::uint32_t> parent_;
};

bool near(const Vec3& a, const Vec3& b, float tolerance) { return max_abs(a - b) <= tolerance; }

}  // namespace

float weld_tolerance(std::span<const Vec3> vertices) {
  float largest = 0.0F;
  for (const Vec3& v : vertices) largest = std::max(largest, max_abs(v));
  return 0x1p-21F * largest;  // a unit in the last place is between 2^-24 and 2^-23 of the number
}

std::vector<std::uint32_t> weld_vertices(std::span<const Vec3> vertices, float tolerance) {
  // Sweep along an odd direction, across which planes of a scene hardly ever lie: the vertices within reach of one
  // another along it are few.
  const Vec3d direction(0.5393919, 0.6457821, 0.5404553);
  struct Swept {
    double along;
    std::uint32_t vertex;
  };
  std::vector<Swept> order(vertices.size());
  for (std::uint32_t i = 0; i < vertices.size(); ++i) order[i] = {glm::dot(Vec3d(vertices[i]), direction), i};
  std::sort(order.begin(), order.end(),
            [](const Swept& a, const Swept& b) { return a.along != b.along ? a.along < b.along : a.vertex < b.vertex; });
  const double reach = 2.0 * static_cast<double>(tolerance);  // the direction's components sum to less than 2
  std::vector<std::uint32_t> weld(vertices.size());
  std::vector<Swept> kept;  // vertices that others are welded to, within reach of the sweep
  std::size_t first = 0;
  for (const Swept& swept : order) {
    while (first < kept.size() && kept[first].along < swept.along - reach) ++first;
    weld[swept.vertex] = swept.vertex;
    for (std::size_t i = first; i < kept.size(); ++i) {
      if (!near(vertices[kept[i].vertex], vertices[swept.vertex], tolerance)) continue;
      weld[swept.vertex] = kept[i].vertex;
      break;
    }
    if (weld[swept.vertex] == swept.vertex) kept.push_back(swept);
  }
  return weld;
}

MeshTopology mesh_topology(std::span<const Face> faces, std::span<const std::uint32_t> weld) {
  MeshTopology topology;
  const std::vector<FaceEdge> edges = sorted_edges(faces, weld);
  Sets sets(faces.size());
  for_each_edge(edges, [&](std::span<const FaceEdge> shared) {
    ++topology.edges;
    if (shared.size() == 1) ++topology.boundary_edges;
    if (shared.size() > 2) ++topology.non_manifold_edges;
    if (shared.size() == 2 && shared[0].backward == shared[1].backward) ++topology.flipped_edges;
    for (const FaceEdge& edge : shared) sets.join(shared[0].face, edge.face);
  });
  std::vector<bool> counted(faces.size(), false);
  for (const FaceEdge& edge : edges) {
    const std::uint32_t root = sets.root(edge.face);
    if (!counted[root]) ++topology.components;
    counted[root] = true;
  }
  topology.closed = topology.edges > 0 && topology.boundary_edges == 0;
  return topology;
}

std::vector<FacePair> neighbouring_faces(std::span<const Face> faces, std::span<const std::uint32_t> weld) {
  std::vector<FacePair> pairs;
  for_each_edge(sorted_edges(faces, weld), [&](std::span<const FaceEdge> shared) {
    if (shared.size() == 2) pairs.push_back({shared[0].face, shared[1].face});
  });
  return pairs;
}

}  // namespace gibench
