#include "methods/antiradiance/sources.h"

#include "common/core/random.h"
#include "common/finite_elements/surface_point.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t leaf_chunk = 32;
constexpr std::uint64_t source_stage = 0x736f75726365ULL;

}  // namespace

std::vector<Rgb> direct_irradiance(const World& world, const DirectLight& light, const Elements& elements,
                                   const Hierarchy& hierarchy, int samples, Task& task) {
  std::vector<Rgb> irradiance(hierarchy.leaf_count());
  task.parallel_chunks(irradiance.size(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    std::vector<SurfaceSample> at;
    std::vector<std::uint64_t> keys;
    std::vector<float> exposed;  // points of every leaf
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t element = hierarchy.order()[leaf];
      const auto points = elements.points(element);
      exposed.push_back(0.0F);
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].exposed) continue;
        const CellPoint& point = points[k];
        at.push_back(surface_sample(world, point.triangle, 0.5F * (point.origin + point.behind), point.normal));
        keys.push_back(mix_keys(task.seed(), source_stage, element * points.size() + k));
        exposed.back() += 1.0F;
      }
    }
    std::vector<Rgb> light_at(at.size());
    light.irradiance(at, keys, samples, rays, light_at);
    std::size_t next = 0;
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const float count = exposed[leaf - range.begin];
      Rgb sum;
      for (float k = 0.0F; k < count; k += 1.0F) sum += light_at[next++];
      if (count > 0.0F) irradiance[leaf] = sum / count;
    }
  });
  return irradiance;
}

}  // namespace gibench::antiradiance
