#include "methods/wavelet/direct_projection.h"

#include <vector>

#include "common/core/random.h"

namespace gibench::wavelet {

namespace {

constexpr std::size_t leaf_chunk = 64;
constexpr std::uint64_t light_stage = 0x77646972656374ULL;

}  // namespace

Coefficients<Rgb> project_direct_light(const World& world, const Elements& elements, const DirectLight& light, int samples,
                                       Task& task) {
  const std::span leaves = elements.leaves();
  std::vector<Rgb> means(leaves.size());
  task.parallel_chunks(leaves.size(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    std::vector<SurfaceSample> at;
    std::vector<std::uint64_t> keys;
    std::vector<std::uint32_t> leaf_of_point;
    std::vector<float> share;
    for (auto leaf = static_cast<std::uint32_t>(range.begin); leaf < range.end; ++leaf) {
      for (const NodePoint& point : elements.points(leaves[leaf])) {
        if (!(point.area > 0.0F)) continue;
        keys.push_back(mix_keys(mix_keys(task.seed(), light_stage), leaf, at.size()));
        at.push_back(elements.sample(world, leaves[leaf], point));
        leaf_of_point.push_back(leaf);
        share.push_back(point.area / elements.nodes()[leaves[leaf]].area);
      }
    }
    std::vector<Rgb> arriving(at.size());
    light.irradiance(at, keys, samples, rays, arriving);
    for (std::size_t i = 0; i < at.size(); ++i) means[leaf_of_point[i]] += arriving[i] * share[i];
  });
  return coefficients_of<Rgb>(elements, means);
}

}  // namespace gibench::wavelet
