#include "bench/micro/interleaved.h"

#include <algorithm>
#include <cmath>

#include "bench/micro/cpu_clock.h"
#include "common/core/parallel.h"
#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"

namespace gibench::micro {

namespace {

// Blocks of a few milliseconds: most of them pass undisturbed on a busy machine, and the median is taken of those.
constexpr std::size_t rays_per_block = 1U << 13, rays_per_chunk = 1U << 10;
constexpr std::uint64_t shuffle_stage = 1, direction_stage = 2, lamp_stage = 3;

Vec3 cosine_direction(const Vec3& normal, float first, float second) {
  const float radius = std::sqrt(first), angle = 2.0F * pi * second;
  return Frame(normal).to_world({radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0F, 1.0F - first))});
}

struct Run {
  double seconds = 0.0;
  std::uint64_t checksum = 0;
};

void trace_block(const TraceRays& trace, std::span<const Ray> rays, int threads, Run& run) {
  std::vector<Run> chunks(chunk_count(rays.size(), rays_per_chunk));
  parallel_chunks(threads, rays.size(), rays_per_chunk, [&](const ChunkRange& range) {
    const double start = thread_seconds();
    const std::uint64_t checksum = trace(rays.subspan(range.begin, range.end - range.begin));
    chunks[range.chunk] = {thread_seconds() - start, checksum};
  });
  for (const Run& chunk : chunks) run.seconds += chunk.seconds, run.checksum += chunk.checksum;
}

bool agree(const Run& a, const Run& b) {
  const auto first = static_cast<double>(a.checksum), second = static_cast<double>(b.checksum);
  return std::fabs(first - second) <= 1e-3 * std::max(first, second);
}

}  // namespace

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::vector<Ray> cosine_rays(const World& world, const RaySet& set) {
  std::vector<SurfaceSample> samples = area_uniform_samples(world, set.count / set.rays_per_point, set.seed);
  for (std::size_t i = samples.size(); i > 1; --i)
    std::swap(samples[i - 1], samples[RandomStream(set.seed, shuffle_stage, i).next_bits() % i]);
  std::vector<Ray> rays;
  rays.reserve(set.count);
  for (std::size_t i = 0; i < samples.size() * set.rays_per_point; ++i) {
    const SurfaceSample& from = samples[i / set.rays_per_point];
    RandomStream random(set.seed, direction_stage, i);
    const float first = random.next_float(), second = random.next_float();
    rays.push_back({world.ray_origin(from), 0.0F, cosine_direction(from.normal, first, second), set.length});
  }
  return rays;
}

std::vector<Ray> rays_to_lamp(const World& world, const RaySet& set) {
  const Scene& scene = world.scene();
  std::vector<std::uint32_t> lamp;
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t)
    if (!is_black(scene.material_of_triangle(t).emission)) lamp.push_back(t);
  std::vector<Ray> rays = cosine_rays(world, set);
  for (std::size_t i = 0; i < rays.size(); ++i) {
    RandomStream random(set.seed, lamp_stage, i);
    const float root = std::sqrt(random.next_float()), second = random.next_float();
    const Vec3 target = world.position(lamp[random.next_bits() % lamp.size()], {root * (1.0F - second), root * second});
    rays[i].direction = target - rays[i].origin;
    rays[i].t_max = 1.0F - 1e-4F;
  }
  return rays;
}

void race(benchmark::State& state, const char* ratio_name, const TraceRays& measured, const TraceRays& yardstick,
          std::span<const Ray> rays, int threads) {
  Run total, total_yardstick;
  std::vector<double> ratios;
  std::size_t block = 0;
  bool first = false;
  for (auto _ : state) {
    const auto part = rays.subspan(block * rays_per_block, rays_per_block);
    block = (block + 1) % (rays.size() / rays_per_block);
    Run run, run_yardstick;
    // A B B A, then B A A B: whoever comes first finds the caches cold.
    for (const bool own : {first, !first, !first, first})
      trace_block(own ? measured : yardstick, part, threads, own ? run : run_yardstick);
    first = !first;
    if (!agree(run, run_yardstick)) state.SkipWithError("the two do not meet the same surfaces");
    ratios.push_back(run_yardstick.seconds / run.seconds);
    total.seconds += run.seconds;
    total_yardstick.seconds += run_yardstick.seconds;
    state.SetIterationTime(run.seconds);
  }
  if (ratios.empty()) return;
  const double traced = 2.0 * static_cast<double>(rays_per_block) * static_cast<double>(ratios.size());
  state.counters[ratio_name] = median(ratios);
  state.counters["rays_per_cpu_second"] = traced / total.seconds;
  state.counters["yardstick_rays_per_cpu_second"] = traced / total_yardstick.seconds;
}

}  // namespace gibench::micro
