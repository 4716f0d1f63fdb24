#include "methods/spectral/vertex_rays.h"

#include <algorithm>
#include <cmath>

namespace gibench::spectral {

namespace {

constexpr std::size_t batch_size = DirectionBatch::capacity;

/// Which of a node's sites a ray leaves from: shares dealt out evenly along the set (additive recurrence by the golden ratio).
/// `shares_up_to`: of every site, with those before it.
std::size_t site_of_ray(const std::vector<double>& shares_up_to, std::size_t ray) {
  const double turn = 0.6180339887498949 * static_cast<double>(ray);
  const auto site = std::upper_bound(shares_up_to.begin(), shares_up_to.end() - 1, turn - std::floor(turn));
  return static_cast<std::size_t>(site - shares_up_to.begin());
}

}  // namespace

VertexRays::VertexRays(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation, const Nodes& nodes,
                       const NodeWeights& weights, int rays, std::uint64_t seed)
    : world_(world), mesh_(mesh), interpolation_(interpolation), nodes_(nodes), weights_(weights), set_(rays, seed), seed_(seed) {
  corners_.reserve(mesh.triangles().size());
  for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
    Corners& corners = corners_.emplace_back();
    corners.vertices = mesh.triangles()[t].corners;
    corners.torn = interpolation.torn(t) ? 1 : 0;
  }
}

/// What the rays of one site share.
struct VertexRays::Leaving {
  Vec3 origin, normal;
  float weight = 0.0F;                ///< of a ray: π times the site's share over its rays
  std::vector<std::uint32_t> places;  ///< in the set, of its rays; empty where all leave here
};

std::vector<VertexRays::Leaving> VertexRays::leaving(std::uint32_t node) const {
  const std::span<const NodeSite> sites = nodes_.sites(node);
  std::vector<Leaving> all;
  std::vector<double> shares_up_to;
  for (const auto& [vertex, site] : sites) {
    const SurfaceSample sample = mesh_.sample(world_, vertex, site);
    all.push_back({world_.ray_origin(sample), sample.normal, pi / static_cast<float>(set_.size()), {}});
    shares_up_to.push_back((shares_up_to.empty() ? 0.0 : shares_up_to.back()) + static_cast<double>(site.share));
  }
  if (sites.size() == 1) return all;
  for (std::uint32_t i = 0; i < set_.size(); ++i) all[site_of_ray(shares_up_to, i)].places.push_back(i);
  float dealt = 0.0F;  // the shares of sites that got rays
  for (std::size_t s = 0; s < sites.size(); ++s) dealt += all[s].places.empty() ? 0.0F : sites[s].site.share;
  std::erase_if(all, [&](Leaving& from) {
    const auto s = static_cast<std::size_t>(&from - all.data());
    from.weight = pi * sites[s].site.share / (dealt * static_cast<float>(std::max<std::size_t>(1, from.places.size())));
    return from.places.empty();
  });
  return all;
}

struct VertexRays::Met {
  alignas(32) std::array<std::uint32_t, batch_size> triangle;
  alignas(32) std::array<float, batch_size> u, v;
};

void VertexRays::trace(std::uint32_t node, RayStream& rays, const std::function<void(std::span<const MeshHit>)>& take) const {
  DirectionBatch batch;
  Met met;
  std::array<MeshHit, batch_size> hits;
  for (const Leaving& from : leaving(node)) {
    const DirectionSet::Turn turn = DirectionSet::turn(seed_, node, from.normal);
    const std::size_t total = from.places.empty() ? set_.size() : from.places.size();
    for (std::size_t begin = 0; begin < total; begin += batch.count) {
      if (from.places.empty()) set_.directions(turn, begin, batch);
      else set_.directions(turn, std::span(from.places).subspan(begin, std::min(batch_size, total - begin)), batch);
      const std::size_t count = batch.count;
      rays.closest_hits({from.origin, {batch.x.data(), count}, {batch.y.data(), count}, {batch.z.data(), count}},
                        {{met.triangle.data(), count}, {met.u.data(), count}, {met.v.data(), count}});
      take({hits.data(), meet(batch, met, from.weight, rays, hits.data())});
    }
  }
}

/// Passes, none of whose memory accesses waits for another of the same pass: which scene triangles are met, where in the mesh
/// that is, then what its triangles hold.
std::size_t VertexRays::meet(const DirectionBatch& batch, const Met& met, float ray_weight, RayStream& rays,
                             MeshHit* hits) const {
  std::array<OuterPoint, batch_size> places;
  std::array<MeshPoint, batch_size> points;
  std::array<std::uint32_t, batch_size> ray;
  std::array<std::uint8_t, batch_size> front;
  std::size_t count = 0;
  for (std::uint32_t i = 0; i < batch.count; ++i) {
    const std::uint32_t triangle = met.triangle[i];
    if (triangle == Hit::none) continue;
    const bool on_front = glm::dot(world_.normal(triangle), batch.direction(i)) < 0.0F;
    if (!mesh_.covers(triangle, on_front)) continue;
    places[count] = {triangle, {met.u[i], met.v[i]}};
    front[count] = on_front ? 1 : 0;
    ray[count++] = i;
  }
  mesh_.prefetch({places.data(), count});
  for (std::size_t i = 0; i < count; ++i) points[i] = mesh_.locate(places[i].outer, places[i].barycentrics, front[i] != 0);
  for (std::size_t i = 0; i < count; ++i) {
    const Corners& corners = corners_[points[i].triangle];
    if (corners.torn != 0) {
      const Vec3 position = world_.position(met.triangle[ray[i]], {met.u[ray[i]], met.v[ray[i]]});
      points[i] = interpolation_.seen(world_, mesh_, points[i], position, rays);
    }
    hits[i].vertices = corners.vertices;
    for (std::size_t c = 0; c < 3; ++c) hits[i].weights[c] = ray_weight * points[i].weights[c];
    hits[i].direction = batch.direction(ray[i]);
  }
  return count;
}

}  // namespace gibench::spectral
