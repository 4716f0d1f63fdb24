#include "methods/spectral/nodes.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "common/core/error.h"
#include "common/finite_elements/grouped.h"

namespace gibench::spectral {

namespace {

constexpr std::size_t most_sites = 64;  // of a node: as many as spread the rays of one over it

std::vector<std::uint32_t> ascending_numbers(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0U);
  return numbers;
}

}  // namespace

Nodes::Nodes(const SamplingMesh& mesh)
    : Nodes(mesh, ascending_numbers(mesh.vertices().size()), [](std::uint32_t, const VertexSite&) { return true; }) {}

Nodes::Nodes(const SamplingMesh& mesh, std::vector<std::uint32_t> node_of_vertex, const IsReached& is_reached)
    : node_of_vertex_(std::move(node_of_vertex)) {
  const auto largest = std::max_element(node_of_vertex_.begin(), node_of_vertex_.end());
  Grouped grouped(node_of_vertex_, largest == node_of_vertex_.end() ? 0 : std::size_t{*largest} + 1);
  vertex_begin_ = std::move(grouped.begin);
  vertices_ = std::move(grouped.items);
  take_means(mesh);
  place_sites(mesh, is_reached);
}

void Nodes::take_means(const SamplingMesh& mesh) {
  for (std::uint32_t node = 0; node + 1 < vertex_begin_.size(); ++node) {
    const std::span<const std::uint32_t> own = vertices(node);
    GIBENCH_CHECK(!own.empty(), "a node has a vertex");
    const MeshVertex& first = mesh.vertices()[own.front()];
    Node& mean = nodes_.emplace_back(Node{first.position, first.normal, first.area, first.object, true});
    if (own.size() == 1) continue;
    Vec3d position(0.0), normal(0.0);
    double area = 0.0;
    for (const std::uint32_t v : own) {
      const MeshVertex& vertex = mesh.vertices()[v];
      const auto share = static_cast<double>(vertex.area);
      position += share * Vec3d(vertex.position);
      normal += share * Vec3d(vertex.normal);
      area += share;
    }
    if (area > 0.0) mean.position = Vec3(position / area);
    if (const double length = glm::length(normal); length > 1e-6 * area) mean.normal = Vec3(normal / length);
    mean.area = static_cast<float>(area);
  }
}

void Nodes::place_sites(const SamplingMesh& mesh, const IsReached& is_reached) {
  site_begin_.assign(1, 0);
  for (std::uint32_t node = 0; node < size(); ++node) {
    std::vector<NodeSite> all, reached;
    for (const std::uint32_t v : vertices(node))
      for (VertexSite site : mesh.sites(v)) {
        const bool counts = is_reached(v, site);
        if (!is_single(node)) site.share *= mesh.vertices()[v].area;
        all.push_back({v, site});
        if (counts) reached.push_back({v, site});
      }
    nodes_[node].reached = !reached.empty();
    const bool some = !reached.empty() && reached.size() < all.size();
    if (some) all = std::move(reached);
    if (some || !is_single(node)) make_shares(all);
    take_sites(mesh, node, std::move(all));
    site_begin_.push_back(static_cast<std::uint32_t>(sites_.size()));
  }
}

/// Of what sites stand for, by their sum; alike where they stand for no area.
void Nodes::make_shares(std::vector<NodeSite>& sites) {
  const float sum =
      std::accumulate(sites.begin(), sites.end(), 0.0F, [](float s, const NodeSite& each) { return s + each.site.share; });
  for (NodeSite& each : sites) each.site.share = sum > 0.0F ? each.site.share / sum : 1.0F / static_cast<float>(sites.size());
}

void Nodes::take_sites(const SamplingMesh& mesh, std::uint32_t node, std::vector<NodeSite> all) {
  GIBENCH_CHECK(!all.empty(), "a node has a site");
  if (all.size() > most_sites) {
    std::vector<NodeSite> chosen;
    double sum = 0.0;
    for (const NodeSite& each : all) {
      sum += static_cast<double>(each.site.share) * most_sites;
      if (chosen.size() < most_sites && sum >= static_cast<double>(chosen.size()) + 0.5) chosen.push_back(each);
    }
    for (NodeSite& each : chosen) each.site.share = 1.0F / static_cast<float>(chosen.size());
    all = std::move(chosen);
  }
  if (!is_single(node)) {
    const auto distance = [&](const NodeSite& each) {
      return glm::length(mesh.vertices()[each.vertex].position - nodes_[node].position);
    };
    std::iter_swap(all.begin(), std::min_element(all.begin(), all.end(), [&](const NodeSite& a, const NodeSite& b) {
                     return distance(a) < distance(b);
                   }));
  }
  sites_.insert(sites_.end(), all.begin(), all.end());
}

void Nodes::keep_sites(std::size_t most) {
  std::vector<NodeSite> kept;
  std::vector<std::uint32_t> begin{0};
  for (std::uint32_t node = 0; node < size(); ++node) {
    const std::span<const NodeSite> own = sites(node);
    kept.insert(kept.end(), own.begin(), own.begin() + static_cast<std::ptrdiff_t>(std::min(most, own.size())));
    begin.push_back(static_cast<std::uint32_t>(kept.size()));
  }
  kept.shrink_to_fit();
  sites_ = std::move(kept);
  site_begin_ = std::move(begin);
}

std::size_t Nodes::bytes() const {
  return nodes_.size() * sizeof(Node) + sites_.size() * sizeof(NodeSite) +
         (node_of_vertex_.size() + vertex_begin_.size() + vertices_.size() + site_begin_.size()) * sizeof(std::uint32_t);
}

}  // namespace gibench::spectral
