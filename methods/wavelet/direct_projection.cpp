#include "methods/wavelet/direct_projection.h"

#include <vector>

#include "common/core/random.h"

namespace gibench::wavelet {

namespace {

constexpr std::size_t leaf_chunk = 64;
constexpr std::uint64_t light_stage = 0x77646972656374ULL;

/// The points of a leaf one child after the other, so that any four lie in four children.
std::size_t point_in_turn(std::uint32_t leaf, std::size_t turn) {
  return turn % child_count * child_count + (turn / child_count + mix_keys(leaf, turn % child_count)) % child_count;
}

}  // namespace

Coefficients<Rgb> project_direct_light(const World& world, const Elements& elements, const DirectLight& light,
                                       const Settings& settings, Task& task) {
  const std::span leaves = elements.leaves();
  std::vector<Rgb> means(leaves.size());
  task.parallel_chunks(leaves.size(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world);
    std::vector<SurfaceSample> at;
    std::vector<std::uint64_t> keys;
    std::vector<std::size_t> leaf_of_point, count(range.end - range.begin, 0);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf)
      for (std::size_t turn = 0; turn < points_a_node; ++turn) {
        const NodePoint& point = elements.points(leaves[leaf])[point_in_turn(leaves[leaf], turn)];
        if (!(point.area > 0.0F) || count[leaf - range.begin] == static_cast<std::size_t>(settings.direct_points)) continue;
        ++count[leaf - range.begin];
        at.push_back(elements.sample(world, leaves[leaf], point));
        keys.push_back(mix_keys(mix_keys(task.seed(), light_stage), leaf, turn));
        leaf_of_point.push_back(leaf);
      }
    std::vector<Rgb> arriving(at.size());
    light.irradiance(at, keys, settings.direct_samples, rays, arriving);
    for (std::size_t i = 0; i < at.size(); ++i)
      means[leaf_of_point[i]] += arriving[i] / static_cast<float>(count[leaf_of_point[i] - range.begin]);
  });
  return coefficients_of<Rgb>(elements, means);
}

}  // namespace gibench::wavelet
