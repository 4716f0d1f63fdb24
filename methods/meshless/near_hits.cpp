#include "methods/meshless/near_hits.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "common/core/random.h"
#include "methods/meshless/expansion.h"
#include "methods/meshless/packed_normal.h"

namespace gibench::meshless {

namespace {

constexpr std::size_t run_rays = 8;      // neighbouring rays that one hit is kept for
constexpr std::size_t point_chunk = 64;  // points
constexpr std::uint64_t choice_stage = 0x6e656172ULL;

/// Where the mean ball of a level subtends a solid angle: 2π (1 − cos θ), sin θ = radius / distance.
float distance_of(const Hierarchy& hierarchy, std::uint32_t level, float solid_angle) {
  const std::uint32_t begin = hierarchy.level_begin(level), end = hierarchy.level_begin(level + 1);
  if (begin == end) return 0.0F;
  if (!(solid_angle > 0.0F)) return std::numeric_limits<float>::infinity();
  double radii = 0.0;
  for (std::uint32_t point = begin; point < end; ++point) radii += static_cast<double>(hierarchy.radius(point));
  const float cosine = std::max(0.0F, 1.0F - solid_angle / (2.0F * pi));
  return static_cast<float>(radii / (end - begin)) / std::sqrt(1.0F - cosine * cosine);
}

}  // namespace

NearHits::NearHits(const Hierarchy& hierarchy, const Groups& groups, std::uint32_t levels, double epsilon_omega,
                   std::uint64_t seed)
    : hierarchy_(hierarchy),
      groups_(groups),
      epsilon_omega_(static_cast<float>(epsilon_omega)),
      seed_(seed),
      slot_(hierarchy.size(), 0) {
  if (levels > 0 && levels < hierarchy.levels()) reach_ = distance_of(hierarchy, levels - 1, epsilon_omega_);
}

void NearHits::announce(std::span<const std::uint32_t> points) {
  for (const std::uint32_t point : points) {
    slot_[point] = static_cast<std::uint32_t>(points_.size());
    points_.push_back(point);
  }
  hits_.resize(points_.size());
}

void NearHits::keep(std::uint32_t point, const Gatherer& gatherer, GatherBuffers& buffers) {
  std::vector<NearHit>& kept = hits_[slot_[point]];
  const Vec3& receiver = hierarchy_.position(point);
  const float share = 1.0F / static_cast<float>(gatherer.rays());
  RandomStream random(seed_, choice_stage, point);
  std::size_t run = gatherer.rays();  // of the last hit that was near
  Rgb own;                            // weight of the hit that stands for the run so far
  float sum = 0.0F;                   // Σ of the largest channel of the run's weights
  for (std::size_t i = 0; i < buffers.lit.size(); ++i) {
    const SurfaceSample& hit = buffers.lit[i];
    const Vec3 apart = hit.position - receiver;
    if (!(glm::dot(apart, apart) < reach_ * reach_)) continue;
    const bool new_run = std::exchange(run, buffers.ray_of_lit[i] / run_rays) != buffers.ray_of_lit[i] / run_rays;
    if (new_run) kept.emplace_back(), sum = 0.0F;
    NearHit& chosen = kept.back();
    const Rgb weight = buffers.albedos[i] * share;
    sum += largest(weight);
    // Each hit of a run is the one that is kept with a chance in proportion to the largest channel of its weight. Its own weight
    // over that chance is right in the mean for every channel, which the sum of the run's weights would not be.
    if (new_run || random.next_float() * sum < largest(weight)) {
      chosen.position = hit.position;
      chosen.normal = pack_normal(hit.normal);
      chosen.group = groups_.of(hit);
      own = weight;
    }
    chosen.weight = own * (sum / largest(own));
  }
  kept.shrink_to_fit();
}

Coefficients NearHits::arriving(const Coefficients& sent, Task& task) const {
  const Expansion expansion(sent);
  std::vector<Rgb> values(points_.size());
  task.parallel_chunks(points_.size(), point_chunk, [&](const ChunkRange& range) {
    std::uint64_t levels_used = 0;
    for (std::size_t i = range.begin; i < range.end; ++i)
      for (const NearHit& hit : hits_[i])
        values[i] += hit.weight * expansion.evaluate_seen({hit.position, unpack_normal(hit.normal), hit.group},
                                                          hierarchy_.position(points_[i]), epsilon_omega_, levels_used);
  });
  Coefficients arriving(hierarchy_, sent.channels());
  for (std::size_t i = 0; i < points_.size(); ++i) arriving.set(points_[i], values[i]);
  return arriving;
}

std::size_t NearHits::size() const {
  std::size_t sum = 0;
  for (const std::vector<NearHit>& hits : hits_) sum += hits.size();
  return sum;
}

std::size_t NearHits::bytes() const {
  std::size_t sum = (points_.capacity() + slot_.capacity()) * sizeof(std::uint32_t) + hits_.capacity() * sizeof(hits_[0]);
  for (const std::vector<NearHit>& hits : hits_) sum += hits.capacity() * sizeof(NearHit);
  return sum;
}

}  // namespace gibench::meshless
