#include "methods/spectral/vertex_rays.h"

#include <algorithm>
#include <cmath>

#include "common/core/random.h"
#include "common/core/sobol.h"

namespace gibench::spectral {

namespace {

constexpr std::uint64_t set_stage = 0x726179736574ULL, turn_stage = 0x7475726eULL;
constexpr std::size_t batch_size = 256;  // rays

/// The place of a point on the curve that keeps neighbours in the square together (Morton).
std::uint64_t along_curve(const SobolPair& point) {
  std::uint64_t key = 0;
  for (int bit = 31; bit >= 0; --bit) key = (key << 2U) | (((point.x >> bit) & 1U) << 1U) | ((point.y >> bit) & 1U);
  return key;
}

/// Which of a vertex's sites a ray leaves from: shares dealt out evenly along the set (additive recurrence by the golden ratio).
std::size_t site_of_ray(std::span<const VertexSite> sites, std::size_t ray) {
  const double turn = 0.6180339887498949 * static_cast<double>(ray);
  double left = turn - std::floor(turn);
  for (std::size_t s = 0; s + 1 < sites.size(); ++s) {
    left -= static_cast<double>(sites[s].share);
    if (left < 0.0) return s;
  }
  return sites.size() - 1;
}

}  // namespace

DirectionSet::DirectionSet(int rays, std::uint64_t seed) {
  const SobolSequence sequence(mix_keys(seed, set_stage));
  std::vector<SobolPair> points;
  for (std::uint32_t i = 0; i < static_cast<std::uint32_t>(rays); ++i) points.push_back(sequence.pair(i, 0));
  std::sort(points.begin(), points.end(), [](const SobolPair& a, const SobolPair& b) { return along_curve(a) < along_curve(b); });
  for (const SobolPair& point : points) {
    const Vec2 u = point.unit();
    elevation_.push_back(u.x);
    cosine_.push_back(std::cos(2.0F * pi * u.y));
    sine_.push_back(std::sin(2.0F * pi * u.y));
  }
}

void DirectionSet::directions(std::uint64_t seed, std::uint32_t vertex, std::span<Vec3> directions) const {
  RandomStream random(seed, turn_stage, vertex);
  const float shift = random.next_float(), angle = 2.0F * pi * random.next_float();
  const float turn_cosine = std::cos(angle), turn_sine = std::sin(angle);
  for (std::size_t i = 0; i < elevation_.size(); ++i) {
    const float shifted = elevation_[i] + shift;
    const float squared = shifted >= 1.0F ? shifted - 1.0F : shifted;
    const float radius = std::sqrt(squared);
    directions[i] = {radius * (cosine_[i] * turn_cosine - sine_[i] * turn_sine),
                     radius * (sine_[i] * turn_cosine + cosine_[i] * turn_sine), std::sqrt(std::max(0.0F, 1.0F - squared))};
  }
}

VertexRays::VertexRays(const World& world, const SamplingMesh& mesh, const Interpolation& interpolation,
                       std::span<const std::uint32_t> slot_of_vertex, int rays, std::uint64_t seed)
    : world_(world), mesh_(mesh), interpolation_(interpolation), set_(rays, seed), seed_(seed) {
  for (const MeshTriangle& triangle : mesh.triangles()) {
    auto& slots = triangle_slots_.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) slots[i] = slot_of_vertex[triangle.corners[i]];
  }
}

/// What the rays of one site share.
struct VertexRays::Leaving {
  Vec3 origin;
  Frame frame;
  float weight = 0.0F;            ///< of a ray: π times the site's share over its rays
  std::vector<std::size_t> rays;  ///< places in the set; empty where all leave here
};

std::vector<VertexRays::Leaving> VertexRays::leaving(std::uint32_t vertex) const {
  const std::span<const VertexSite> sites = mesh_.sites(vertex);
  std::vector<Leaving> all;
  for (const VertexSite& site : sites) {
    const SurfaceSample sample = mesh_.sample(world_, vertex, site);
    all.push_back({world_.ray_origin(sample), Frame(sample.normal), pi / static_cast<float>(set_.size()), {}});
  }
  if (sites.size() == 1) return all;
  for (std::size_t i = 0; i < set_.size(); ++i) all[site_of_ray(sites, i)].rays.push_back(i);
  float dealt = 0.0F;  // the shares of sites that got rays
  for (std::size_t s = 0; s < sites.size(); ++s) dealt += all[s].rays.empty() ? 0.0F : sites[s].share;
  std::erase_if(all, [&](Leaving& from) {
    const auto s = static_cast<std::size_t>(&from - all.data());
    from.weight = pi * sites[s].share / (dealt * static_cast<float>(std::max<std::size_t>(1, from.rays.size())));
    return from.rays.empty();
  });
  return all;
}

void VertexRays::trace(std::uint32_t vertex, RayStream& rays, const std::function<void(std::span<const MeshHit>)>& take) const {
  std::vector<Vec3> directions(set_.size());
  set_.directions(seed_, vertex, directions);
  std::array<Ray, batch_size> batch;
  std::array<MeshHit, batch_size> hits;
  for (const Leaving& from : leaving(vertex)) {
    const std::size_t total = from.rays.empty() ? set_.size() : from.rays.size();
    for (std::size_t begin = 0; begin < total; begin += batch_size) {
      const std::size_t count = std::min(batch_size, total - begin);
      for (std::size_t i = 0; i < count; ++i)
        batch[i] = {from.origin, 0.0F, from.frame.to_world(directions[from.rays.empty() ? begin + i : from.rays[begin + i]])};
      take({hits.data(), trace_batch({batch.data(), count}, from.weight, rays, hits.data())});
    }
  }
}

std::size_t VertexRays::trace_batch(std::span<const Ray> batch, float ray_weight, RayStream& rays, MeshHit* hits) const {
  std::array<Hit, batch_size> met;
  rays.closest_hits(batch, {met.data(), batch.size()});
  std::size_t count = 0;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Hit& hit = met[i];
    if (!hit) continue;
    const Vec3& direction = batch[i].direction;
    const bool front = glm::dot(world_.normal(hit.triangle), direction) < 0.0F;
    if (!mesh_.covers(hit.triangle, front)) continue;
    MeshPoint point = mesh_.locate(hit.triangle, {hit.u, hit.v}, front);
    if (interpolation_.torn(point.triangle))
      point = interpolation_.seen(world_, mesh_, point, world_.position(hit.triangle, {hit.u, hit.v}), rays);
    MeshHit& kept = hits[count++];
    kept.slots = triangle_slots_[point.triangle];
    for (std::size_t c = 0; c < 3; ++c) kept.weights[c] = ray_weight * point.weights[c];
    kept.direction = direction;
  }
  return count;
}

}  // namespace gibench::spectral
