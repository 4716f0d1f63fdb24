#include "methods/meshless/coarsest_shares.h"

#include <algorithm>
#include <utility>

#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"

namespace gibench::meshless {

namespace {

constexpr std::uint64_t share_stage = 0x7368617265ULL;
constexpr std::size_t looks_a_point = 64, most_looks = std::size_t{1} << 18U;  // places, uniform by area
constexpr std::size_t look_chunk = 512;

}  // namespace

std::vector<double> coarsest_shares(const World& world, const Groups& groups, const Hierarchy& hierarchy, Task& task) {
  const std::uint32_t points = hierarchy.levels() > 0 ? hierarchy.level_size(0) : 0;
  const std::vector<SurfaceSample> looks =
      area_uniform_samples(world, std::min(most_looks, looks_a_point * points), mix_keys(task.seed(), share_stage));
  using Part = std::vector<std::pair<std::uint32_t, float>>;  // of a chunk: points and how much of a look is theirs
  std::vector<Part> parts(chunk_count(looks.size(), look_chunk));
  task.parallel_chunks(looks.size(), look_chunk, [&](const ChunkRange& range) {
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const Place at{looks[i].position, looks[i].normal, groups.of(looks[i])};
      float sum = 0.0F;
      const std::size_t first = parts[range.chunk].size();
      hierarchy.visit_covering(0, at, [&](std::uint32_t point, float weight) {
        parts[range.chunk].emplace_back(point, weight);
        sum += weight;
      });
      for (std::size_t p = first; p < parts[range.chunk].size(); ++p) parts[range.chunk][p].second /= sum;
    }
  });
  std::vector<double> shares(points, 0.0);
  double covered = 0.0;
  for (const Part& part : parts)
    for (const auto& [point, share] : part) shares[point] += static_cast<double>(share), covered += static_cast<double>(share);
  if (!(covered > 0.0)) return {};
  for (double& share : shares) share /= covered;
  return shares;
}

}  // namespace gibench::meshless
