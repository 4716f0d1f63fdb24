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
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t element = hierarchy.order()[leaf];
      const auto points = elements.points(element);
      Rgb sum;
      float count = 0.0F;
      for (std::size_t k = 0; k < points.size(); ++k) {
        if (!points[k].exposed) continue;
        const CellPoint& point = points[k];
        const SurfaceSample sample = surface_sample(world, point.triangle, 0.5F * (point.origin + point.behind), point.normal);
        sum += light.irradiance(sample, mix_keys(task.seed(), source_stage, element * points.size() + k), samples, rays);
        count += 1.0F;
      }
      if (count > 0.0F) irradiance[leaf] = sum / count;
    }
  });
  return irradiance;
}

}  // namespace gibench::antiradiance
