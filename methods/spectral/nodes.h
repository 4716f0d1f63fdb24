/// The places that hold light: the vertices of the sampling mesh, or clusters of them.
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/geometry/sampling_mesh.h"

namespace gibench::spectral {

/// One vertex or several that lie together: their mean by area.
struct Node {
  Vec3 position{0.0F};
  Vec3 normal{0.0F};         ///< unit
  float area = 0.0F;         ///< m²
  std::uint32_t object = 0;  ///< of one of them; all are of its material
  bool reached = true;       ///< by light, as far as that was looked into
};

/// Where rays of a node start: a site of one of its vertices.
struct NodeSite {
  std::uint32_t vertex = 0;
  VertexSite site;  ///< its share is that of the node's area
};

class Nodes {
 public:
  Nodes() = default;
  /// Every vertex is a node, under its own number.
  explicit Nodes(const SamplingMesh& mesh);
  /// Whether light reaches a site of a vertex.
  using IsReached = std::function<bool(std::uint32_t vertex, const VertexSite& site)>;
  /// `node_of_vertex`: numbers from 0 on, none of them without a vertex. A node has the sites of its vertices that light reaches,
  /// all of them where it reaches none; of many evenly spread ones by area, the most central first.
  Nodes(const SamplingMesh& mesh, std::vector<std::uint32_t> node_of_vertex, const IsReached& is_reached);

  std::uint32_t size() const { return static_cast<std::uint32_t>(nodes_.size()); }
  const Node& operator[](std::uint32_t node) const { return nodes_[node]; }
  bool are_vertices() const { return nodes_.size() == node_of_vertex_.size(); }
  std::uint32_t of_vertex(std::uint32_t vertex) const { return node_of_vertex_[vertex]; }
  std::span<const std::uint32_t> vertices(std::uint32_t node) const {
    return std::span(vertices_).subspan(vertex_begin_[node], vertex_begin_[node + 1] - vertex_begin_[node]);
  }
  bool is_single(std::uint32_t node) const { return vertex_begin_[node + 1] - vertex_begin_[node] == 1; }
  std::span<const NodeSite> sites(std::uint32_t node) const {
    return std::span(sites_).subspan(site_begin_[node], site_begin_[node + 1] - site_begin_[node]);
  }

  /// Leaves every node no more than so many sites, the most central first: all that is needed once its rays have run.
  void keep_sites(std::size_t most);

  std::size_t bytes() const;

 private:
  void take_means(const SamplingMesh& mesh);
  void place_sites(const SamplingMesh& mesh, const IsReached& is_reached);
  static void make_shares(std::vector<NodeSite>& sites);
  void take_sites(const SamplingMesh& mesh, std::uint32_t node, std::vector<NodeSite> all);

  std::vector<Node> nodes_;
  std::vector<std::uint32_t> node_of_vertex_;
  std::vector<std::uint32_t> vertex_begin_, vertices_;  ///< of every node
  std::vector<std::uint32_t> site_begin_;
  std::vector<NodeSite> sites_;
};

}  // namespace gibench::spectral
