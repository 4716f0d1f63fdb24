#include "methods/meshless/crossings.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace gibench::meshless {

namespace {

constexpr std::size_t most_tried = 1024;  // samples
constexpr std::size_t trial_chunk = 32;
constexpr float lift = 1.0F / 1024.0F;  // of the distance between the two places, at least

/// Whether something stands between a sample and a basis point. The ray is lifted above the surface that both lie on, which
/// between them may stick out by the distance times half the sine of half the angle of their normals at most.
bool hidden(const World& world, const SurfaceSample& sample, const Vec3& position, const Vec3& normal, RayStream& rays) {
  const Vec3 origin = world.ray_origin(sample);
  const float half_angle_sine = std::sqrt(std::max(0.0F, 0.5F * (1.0F - glm::dot(sample.normal, normal))));
  const float height = std::max(lift, half_angle_sine) * glm::length(position - sample.position);
  const Vec3 from = origin + height * sample.normal;
  const Vec3 to = position + (origin - sample.position) + height * normal;
  return rays.occluded({from, 0.0F, to - from, 1.0F});
}

}  // namespace

Crossings find_crossings(const World& world, const Groups& groups, const Expansion& expansion,
                         std::span<const SurfaceSample> samples, Task& task) {
  const std::size_t step = std::max<std::size_t>(1, (samples.size() + most_tried - 1) / most_tried);
  const std::size_t tried = (samples.size() + step - 1) / step;
  std::vector<Crossings> chunks(chunk_count(tried, trial_chunk));
  task.parallel_chunks(tried, trial_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const SurfaceSample& sample = samples[i * step];
      if (!sample.lit_side) continue;
      bool crossed = false;
      expansion.visit_finest({sample.position, sample.normal, groups.of(sample)}, [&](const Vec3& position, const Vec3& normal) {
        crossed = crossed || hidden(world, sample, position, normal, rays);
      });
      ++chunks[range.chunk].tried;
      chunks[range.chunk].crossed += crossed ? 1U : 0U;
    }
  });
  Crossings all;
  for (const Crossings& chunk : chunks) all.tried += chunk.tried, all.crossed += chunk.crossed;
  return all;
}

}  // namespace gibench::meshless
