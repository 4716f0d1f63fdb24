#include "bench/micro/method_timing.h"

#include "bench/micro/cpu_clock.h"
#include "bench/micro/interleaved.h"
#include "common/core/parallel.h"

namespace gibench::micro {

namespace {

constexpr std::size_t rays_per_chunk = 1U << 12;

/// CPU seconds for each ray of the bare loop.
struct BareCost {
  double closest = 0.0, shadow = 0.0;
};

template <class Trace>
double seconds_per_ray(std::span<const Ray> rays, int threads, const Trace& trace) {
  const double start = process_seconds();
  parallel_chunks(threads, rays.size(), rays_per_chunk, [&](const ChunkRange& range) {
    benchmark::DoNotOptimize(trace(rays.subspan(range.begin, range.end - range.begin)));
  });
  return (process_seconds() - start) / static_cast<double>(rays.size());
}

BareCost bare_cost(const BareEmbree& bare, std::span<const Ray> closest, std::span<const Ray> shadow, int threads) {
  return {seconds_per_ray(closest, threads, [&](std::span<const Ray> rays) { return bare.closest_hits(rays); }),
          seconds_per_ray(shadow, threads, [&](std::span<const Ray> rays) { return bare.occlusions(rays); })};
}

}  // namespace

void time_against_bare(benchmark::State& state, const BareEmbree& bare, std::span<const Ray> closest, std::span<const Ray> shadow,
                       int threads, const std::function<Work()>& work) {
  std::vector<double> same_mix, closest_only, rates;
  for (auto _ : state) {
    const BareCost before = bare_cost(bare, closest, shadow, threads);
    const Work done = work();
    const BareCost after = bare_cost(bare, closest, shadow, threads);
    const auto hits = static_cast<double>(done.counters["closest_hit_rays"]);
    const auto occlusions = static_cast<double>(done.counters["occlusion_rays"]);
    const double hit_cost = 0.5 * (before.closest + after.closest), shadow_cost = 0.5 * (before.shadow + after.shadow);
    same_mix.push_back((hits * hit_cost + occlusions * shadow_cost) / done.seconds);
    closest_only.push_back((hits + occlusions) * hit_cost / done.seconds);
    rates.push_back((hits + occlusions) / done.seconds);
    state.SetIterationTime(done.seconds);
    state.counters["closest_hit_rays"] = hits;
    state.counters["occlusion_rays"] = occlusions;
  }
  if (same_mix.empty()) return;
  state.counters["over_bare_same_mix"] = median(same_mix);
  state.counters["over_bare_closest_hits"] = median(closest_only);
  state.counters["rays_per_cpu_second"] = median(rates);
}

}  // namespace gibench::micro
