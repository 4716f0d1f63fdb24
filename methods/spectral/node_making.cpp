#include "methods/spectral/node_making.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "common/core/disjoint_sets.h"
#include "common/finite_elements/grouped.h"
#include "common/spaces/place_clusters.h"
#include "common/spaces/proximity_joins.h"
#include "methods/spectral/node_sight.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t cluster_chunk = 64, edge_chunk = 512;
constexpr double own_nodes = 8.0;    // a piece as large as so many nodes comes together with no other
constexpr double bright_from = 2.0;  // of the mean irradiance of what light reaches: from there on a place counts as bright
constexpr std::size_t bright_share = 2, sealed_share = 8;  // of the nodes wanted: as many more where it is bright, and sealed
constexpr float least_cosine = 0.7F;                       // between the normals of a vertex and its cluster
constexpr float height_share = 0.25F;   // of a cluster's radius, of the length of an edge: from how far above it is looked
constexpr int most_looks = 4;           // after which what is still hidden stays together
constexpr std::size_t many_pieces = 2;  // times as many as wanted: only then they are joined
constexpr double least_join = 0.05, most_join = 1.0;  // weights of edges between joined pieces; those of a mesh are about one

/// Pieces of the mesh that uncut edges hold together, and their areas.
class MeshPieces {
 public:
  MeshPieces(const SamplingMesh& mesh, const Interpolation& interpolation)
      : sets_(mesh.vertices().size()), area_(mesh.vertices().size(), 0.0) {
    for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (!interpolation.edge_cut(t, i)) sets_.join(mesh.triangles()[t].corners[i], mesh.triangles()[t].corners[(i + 1) % 3]);
    for (std::uint32_t v = 0; v < area_.size(); ++v) area_[sets_.find(v)] += static_cast<double>(mesh.vertices()[v].area);
  }
  std::uint32_t of(std::uint32_t vertex) { return sets_.find(vertex); }
  double area(std::uint32_t piece) const { return area_[piece]; }  ///< m²

 private:
  DisjointSets sets_;
  std::vector<double> area_;
};

/// What a vertex gets nodes for.
enum class Space : std::uint8_t { bright, lit, sealed };

/// Bright: more than twice the mean of all lit surfaces, where light changes over short ways.
std::vector<Space> spaces_of(const World& world, const SamplingMesh& mesh, const SideLight& light) {
  std::vector<Space> spaces;
  std::vector<float> irradiance;
  double sum = 0.0, area = 0.0;
  for (std::uint32_t v = 0; v < mesh.vertices().size(); ++v) {
    const MeshVertex& vertex = mesh.vertices()[v];
    bool reached = false;
    float most = 0.0F;
    for (const VertexSite& site : mesh.sites(v)) {
      reached = reached || light.is_reached(mesh.sample(world, v, site));
      most = std::max(most, light.irradiance(site.scene_triangle, vertex.front, site.barycentrics));
    }
    spaces.push_back(reached ? Space::lit : Space::sealed);
    irradiance.push_back(most);
    if (!reached) continue;
    sum += static_cast<double>(vertex.area) * static_cast<double>(most);
    area += static_cast<double>(vertex.area);
  }
  for (std::size_t v = 0; v < spaces.size(); ++v)
    if (spaces[v] == Space::lit && static_cast<double>(irradiance[v]) * area > bright_from * sum) spaces[v] = Space::bright;
  return spaces;
}

/// Vertices as places, with labels that tell apart what must not come together.
std::vector<Place> places_of(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation,
                             const std::vector<Space>& spaces, std::size_t wanted) {
  using Key = std::tuple<std::uint32_t, std::uint32_t, bool, bool>;  // piece or none of its own, material, side, space
  constexpr std::uint32_t no_piece = 0xffffffffU;
  double area = 0.0;
  for (std::uint32_t v = 0; v < spaces.size(); ++v)
    area += spaces[v] != Space::sealed ? static_cast<double>(mesh.vertices()[v].area) : 0.0;
  const double large = own_nodes * area / static_cast<double>(wanted);
  MeshPieces pieces(mesh, interpolation);
  std::map<Key, std::uint32_t> labels;
  std::vector<Place> places;
  places.reserve(spaces.size());
  for (std::uint32_t v = 0; v < spaces.size(); ++v) {
    const MeshVertex& vertex = mesh.vertices()[v];
    const std::uint32_t piece = pieces.of(v);
    const Key key(pieces.area(piece) > large ? piece : no_piece, world.scene().objects[vertex.object].material, vertex.front,
                  spaces[v] != Space::sealed);
    const auto label = labels.try_emplace(key, static_cast<std::uint32_t>(labels.size())).first->second;
    places.push_back({vertex.position, vertex.normal, vertex.area, label});
  }
  return places;
}

/// Clusters of the places of every kind, each down to its count; those of one kind have numbers behind the one before.
std::vector<std::uint32_t> clusters_of(const std::vector<Place>& places, const std::vector<Space>& spaces, std::size_t wanted,
                                       Task& task) {
  std::vector<std::uint32_t> cluster(places.size());
  std::uint32_t first = 0;
  for (const auto& [space, most] :
       {std::pair(Space::bright, wanted / bright_share), {Space::lit, wanted}, {Space::sealed, wanted / sealed_share}}) {
    std::vector<Place> own;
    std::vector<std::uint32_t> number;
    for (std::uint32_t i = 0; i < places.size(); ++i)
      if (spaces[i] == space) own.push_back(places[i]), number.push_back(i);
    const std::vector<std::uint32_t> made = cluster_places(own, {std::max<std::size_t>(1, most), least_cosine}, task);
    for (std::size_t i = 0; i < made.size(); ++i) cluster[number[i]] = first + made[i];
    first += static_cast<std::uint32_t>(cluster_count(made));
  }
  return cluster;
}

/// Parts clusters whose vertices do not see the most central one: those hidden from it, and those hidden from the most central
/// of these, are clusters of their own.
class Parting {
 public:
  Parting(const World& world, const SamplingMesh& mesh) : world_(world), mesh_(mesh) {}

  /// Which part of its cluster each member is in, and how many parts there are.
  std::uint32_t part(std::span<const std::uint32_t> members, RayStream& rays, std::vector<std::uint32_t>& part_of_vertex) const {
    if (members.size() == 1) return 1;
    std::vector<std::uint32_t> left(members.begin(), members.end()), hidden;
    std::uint32_t part = 0;
    for (; !left.empty() && part < most_looks; ++part) {
      const auto [centre, radius] = middle_of(left);
      hidden.clear();
      for (const std::uint32_t v : left) {
        part_of_vertex[v] = part;
        if (v != centre && !see_each_other(world_, mesh_, centre, v, height_share * radius, rays)) hidden.push_back(v);
      }
      std::swap(left, hidden);
    }
    for (const std::uint32_t v : left) part_of_vertex[v] = part;
    return left.empty() ? part : part + 1;
  }

 private:
  std::pair<std::uint32_t, float> middle_of(const std::vector<std::uint32_t>& members) const {
    Vec3 mean(0.0F);
    for (const std::uint32_t v : members) mean += mesh_.vertices()[v].position / static_cast<float>(members.size());
    std::uint32_t nearest = members.front();
    float least = std::numeric_limits<float>::infinity(), radius = 0.0F;
    for (const std::uint32_t v : members) {
      const float distance = glm::length(mesh_.vertices()[v].position - mean);
      radius = std::max(radius, distance);
      if (distance < least) least = distance, nearest = v;
    }
    return {nearest, radius};
  }

  const World& world_;
  const SamplingMesh& mesh_;
};

/// What light does not reach needs no parting.
std::vector<std::uint32_t> parted_by_sight(const World& world, const SamplingMesh& mesh, std::vector<std::uint32_t> cluster,
                                           const std::vector<Space>& spaces, Task& task) {
  const Grouped clusters(cluster, cluster_count(cluster));
  std::vector<std::uint32_t> part(cluster.size(), 0), first(clusters.groups() + 1, 0);
  const Parting parting(world, mesh);
  task.parallel_chunks(clusters.groups(), cluster_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t c = range.begin; c < range.end; ++c)
      first[c + 1] = spaces[clusters.of(c).front()] != Space::sealed ? parting.part(clusters.of(c), rays, part) : 1;
  });
  for (std::size_t c = 0; c < clusters.groups(); ++c) first[c + 1] += first[c];
  for (std::size_t v = 0; v < cluster.size(); ++v) cluster[v] = first[cluster[v]] + part[v];
  return cluster;
}

}  // namespace

Nodes cluster_vertices(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation, const SideLight& light,
                       std::size_t wanted, Task& task) {
  const std::vector<Space> spaces = spaces_of(world, mesh, light);
  const std::vector<Place> places = places_of(world, mesh, interpolation, spaces, wanted);
  std::vector<std::uint32_t> cluster = clusters_of(places, spaces, wanted, task);
  if (task.cancelled()) return Nodes(mesh);
  cluster = parted_by_sight(world, mesh, std::move(cluster), spaces, task);
  if (task.cancelled()) return Nodes(mesh);
  return {mesh, std::move(cluster),
          [&](std::uint32_t vertex, const VertexSite& site) { return light.is_reached(mesh.sample(world, vertex, site)); }};
}

SurfaceGraph graph_of(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes,
                      Task& task) {
  SurfaceGraph graph = make_graph(mesh, interpolation, nodes);
  if (nodes.are_vertices()) return graph;
  struct Edge {
    std::uint32_t from, to;
  };
  std::vector<Edge> edges;  // that the triangles' own tests did not settle
  for (std::uint32_t node = 0; node < nodes.size(); ++node)
    for (const std::uint32_t other : graph.neighbours(node))
      if (node < other && nodes[node].reached && nodes[other].reached && !(nodes.is_single(node) && nodes.is_single(other)))
        edges.push_back({node, other});
  std::vector<std::uint8_t> hidden(edges.size(), 0);
  task.parallel_chunks(edges.size(), edge_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const auto [from, to] = edges[i];
      const float height = height_share * glm::length(nodes[from].position - nodes[to].position);
      hidden[i] = see_each_other(world, mesh, central_vertex(nodes, from), central_vertex(nodes, to), height, rays) ? 0 : 1;
    }
  });
  std::vector<std::pair<std::uint32_t, std::uint32_t>> left_out;
  for (std::size_t i = 0; i < edges.size(); ++i)
    if (hidden[i] != 0) left_out.emplace_back(edges[i].from, edges[i].to);
  graph.thin([&](std::uint32_t from, std::uint32_t to) {
    return std::binary_search(left_out.begin(), left_out.end(), std::pair(std::min(from, to), std::max(from, to)));
  });
  return graph;
}

void join_pieces(const World& world, const SamplingMesh& mesh, const Nodes& nodes, std::size_t wanted, float near,
                 SurfaceGraph& graph, Task& task) {
  const Pieces pieces = connected_pieces(graph, std::vector<std::uint32_t>(graph.size(), 0));
  task.count("pieces", pieces.count);
  if (pieces.count <= many_pieces * wanted) return;
  std::vector<Place> places;
  for (std::uint32_t node = 0; node < nodes.size(); ++node) {
    const std::uint32_t side = mesh.vertices()[central_vertex(nodes, node)].front ? 0 : 1;
    places.push_back({nodes[node].position, nodes[node].normal, nodes[node].area, 2 * side + (nodes[node].reached ? 1 : 0)});
  }
  const std::vector<Join> joins = join_small_pieces(places, pieces.of_node, wanted, near, task);
  std::vector<AddedEdge> edges;
  RayStream rays = task.rays(world);
  for (const Join& join : joins) {
    const float distance = glm::length(nodes[join.from].position - nodes[join.to].position);
    if (nodes[join.from].reached && !see_each_other(world, mesh, central_vertex(nodes, join.from), central_vertex(nodes, join.to),
                                                    height_share * distance, rays))
      continue;
    const double size = std::sqrt(static_cast<double>(std::min(nodes[join.from].area, nodes[join.to].area)));
    edges.push_back({join.from, join.to, std::clamp(size / static_cast<double>(distance), least_join, most_join)});
  }
  task.count("joined_pieces", edges.size());
  graph.add(edges);
}

}  // namespace gibench::spectral
