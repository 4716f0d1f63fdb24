#include "methods/spectral/node_weights.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace gibench::spectral {

namespace {

constexpr std::size_t vertex_chunk = 4096;
constexpr std::size_t most_nodes = 32;  // of a vertex
// Squared, in standard deviations of a node's area: those of a rectangle are half a side over √3, so that this is a whole side.
constexpr float reach = 12.0F;
constexpr float thickness = 0.05F;    // squared, what is added along every axis, share of the sum over them: flat areas have none
constexpr float least_cosine = 0.5F;  // between the normals of a vertex and a node that is not its own
constexpr float least_weight = 0.005F;   // what is less is left out
constexpr float regularisation = 0.05F;  // of the second moments, share of their trace: flat neighbourhoods have no depth

/// What a vertex takes from.
struct Candidates {
  std::array<std::uint32_t, most_nodes> node;
  std::array<float, most_nodes> weight;
  std::size_t count = 0;

  void add(std::uint32_t number, float w) {
    if (count == most_nodes) return;
    node[count] = number;
    weight[count++] = w;
  }
  void normalise() {
    float sum = 0.0F;
    for (std::size_t i = 0; i < count; ++i) sum += weight[i];
    for (std::size_t i = 0; i < count; ++i) weight[i] /= sum;
  }
};

class Weighing {
 public:
  Weighing(const World& world, const SamplingMesh& mesh, const Nodes& nodes, const SurfaceGraph& graph)
      : world_(world), mesh_(mesh), nodes_(nodes), graph_(graph) {
    for (std::uint32_t node = 0; node < nodes.size(); ++node) metric_.push_back(metric_of(node));
    beside_.resize(nodes.size());
    for (std::uint32_t node = 0; node < nodes.size(); ++node)
      if (!nodes.is_single(node)) find_beside(node);
  }

  Candidates weights_of(std::uint32_t vertex) const {
    const std::uint32_t own = nodes_.of_vertex(vertex);
    Candidates taken;
    if (!nodes_.is_single(own)) {
      weigh(own, vertex, taken);
      for (const std::uint32_t other : beside_[own])
        if (glm::dot(mesh_.vertices()[vertex].normal, nodes_[other].normal) >= least_cosine) weigh(other, vertex, taken);
    }
    if (taken.count == 0) {
      taken.add(own, 1.0F);
      return taken;
    }
    taken.normalise();
    tilt(mesh_.vertices()[vertex].position, taken);
    leave_out_small(taken);
    return taken;
  }

 private:
  bool alike(std::uint32_t a, std::uint32_t b) const {
    const auto& objects = world_.scene().objects;
    return nodes_[a].reached == nodes_[b].reached && objects[nodes_[a].object].material == objects[nodes_[b].object].material;
  }

  void find_beside(std::uint32_t node) {
    std::vector<std::uint32_t>& found = beside_[node];
    for (const std::uint32_t other : graph_.neighbours(node)) {
      if (!alike(node, other)) continue;
      found.push_back(other);
      for (const std::uint32_t next : graph_.neighbours(other))
        if (next != node && alike(node, next)) found.push_back(next);
    }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
  }

  /// The inverse of the covariance of the node's area: distances in it are in standard deviations.
  glm::mat3 metric_of(std::uint32_t node) const {
    glm::mat3 sum(0.0F);
    for (const std::uint32_t v : nodes_.vertices(node)) {
      const MeshVertex& vertex = mesh_.vertices()[v];
      const Vec3 off = vertex.position - nodes_[node].position;
      const float share = nodes_[node].area > 0.0F ? vertex.area / nodes_[node].area : 1.0F;
      sum += share * (glm::outerProduct(off, off) + glm::mat3(vertex.area / 12.0F));
    }
    const float trace = sum[0][0] + sum[1][1] + sum[2][2];
    return glm::inverse(sum + glm::mat3(thickness * trace + 1e-20F));
  }

  void weigh(std::uint32_t node, std::uint32_t vertex, Candidates& taken) const {
    const Vec3 apart = nodes_[node].position - mesh_.vertices()[vertex].position;
    const float squared = glm::dot(apart, metric_[node] * apart);
    if (!(squared < reach)) return;
    const float root = 1.0F - squared / reach;
    taken.add(node, root * root);
  }

  /// wᵢ (1 + b · (xᵢ − x̄)) has the mean x̄ + M b, M the second moments: b = M⁻¹ (x − x̄), shortened where a weight fell below zero.
  void tilt(const Vec3& position, Candidates& taken) const {
    Vec3 mean(0.0F);
    for (std::size_t i = 0; i < taken.count; ++i) mean += taken.weight[i] * nodes_[taken.node[i]].position;
    glm::mat3 moments(0.0F);
    for (std::size_t i = 0; i < taken.count; ++i) {
      const Vec3 off = nodes_[taken.node[i]].position - mean;
      moments += taken.weight[i] * glm::outerProduct(off, off);
    }
    const float trace = moments[0][0] + moments[1][1] + moments[2][2];
    if (!(trace > 0.0F)) return;
    moments += glm::mat3(regularisation * trace);
    const Vec3 slope = glm::inverse(moments) * (position - mean);
    float steepest = 0.0F;
    for (std::size_t i = 0; i < taken.count; ++i)
      steepest = std::max(steepest, -glm::dot(slope, nodes_[taken.node[i]].position - mean));
    const float scale = steepest > 1.0F ? 1.0F / steepest : 1.0F;
    for (std::size_t i = 0; i < taken.count; ++i)
      taken.weight[i] *= std::max(0.0F, 1.0F + scale * glm::dot(slope, nodes_[taken.node[i]].position - mean));
  }

  static void leave_out_small(Candidates& taken) {
    taken.normalise();
    std::size_t kept = 0;
    for (std::size_t i = 0; i < taken.count; ++i) {
      if (taken.weight[i] < least_weight) continue;
      taken.node[kept] = taken.node[i];
      taken.weight[kept++] = taken.weight[i];
    }
    taken.count = kept;
    taken.normalise();
  }

  const World& world_;
  const SamplingMesh& mesh_;
  const Nodes& nodes_;
  const SurfaceGraph& graph_;
  std::vector<glm::mat3> metric_;                   // of every node, 1/m²
  std::vector<std::vector<std::uint32_t>> beside_;  // of every node of several vertices: alike ones, one and two edges away
};

}  // namespace

NodeWeights::NodeWeights(const World& world, const SamplingMesh& mesh, const Nodes& nodes, const SurfaceGraph& graph,
                         Task& task) {
  const std::size_t vertices = mesh.vertices().size();
  if (nodes.are_vertices()) {
    for (std::uint32_t v = 0; v < vertices; ++v) weights_.push_back({v, 1.0F});
    return;
  }
  const Weighing weighing(world, mesh, nodes, graph);
  std::vector<std::vector<NodeWeight>> made(chunk_count(vertices, vertex_chunk));
  std::vector<std::uint32_t> counts(vertices, 0);
  task.parallel_chunks(vertices, vertex_chunk, [&](const ChunkRange& range) {
    for (std::size_t v = range.begin; v < range.end; ++v) {
      const Candidates taken = weighing.weights_of(static_cast<std::uint32_t>(v));
      counts[v] = static_cast<std::uint32_t>(taken.count);
      for (std::size_t i = 0; i < taken.count; ++i) made[range.chunk].push_back({taken.node[i], taken.weight[i]});
    }
  });
  begin_.assign(1, 0);
  for (const std::uint32_t count : counts) begin_.push_back(begin_.back() + count);
  for (const std::vector<NodeWeight>& chunk : made) weights_.insert(weights_.end(), chunk.begin(), chunk.end());
}

void NodeWeights::renumber(std::span<const std::uint32_t> slot_of_node) {
  for (NodeWeight& each : weights_) each.slot = slot_of_node[each.slot];
}

}  // namespace gibench::spectral
