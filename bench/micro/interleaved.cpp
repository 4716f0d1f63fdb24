#include "bench/micro/interleaved.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <limits>

#include "common/core/parallel.h"
#include "common/core/random.h"
#include "common/geometry/surface_sampling.h"

namespace gibench::micro {

namespace {

constexpr std::size_t rays_per_block = 1U << 16, rays_per_chunk = 1U << 12;
constexpr std::uint64_t shuffle_stage = 1, direction_stage = 2;

Vec3 cosine_direction(const Vec3& normal, float first, float second) {
  const float radius = std::sqrt(first), angle = 2.0F * pi * second;
  return Frame(normal).to_world({radius * std::cos(angle), radius * std::sin(angle), std::sqrt(std::max(0.0F, 1.0F - first))});
}

struct Run {
  double seconds = 0.0;
  std::uint64_t checksum = 0;
};

void trace_block(const TraceRays& trace, std::span<const Ray> rays, int threads, Run& run) {
  std::atomic<std::uint64_t> sum{0};
  run.seconds += seconds_of([&] {
    parallel_chunks(threads, rays.size(), rays_per_chunk, [&](const ChunkRange& range) {
      sum.fetch_add(trace(rays.subspan(range.begin, range.end - range.begin)), std::memory_order_relaxed);
    });
  });
  run.checksum += sum.load();
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

bool agree(const Run& a, const Run& b) {
  const auto first = static_cast<double>(a.checksum), second = static_cast<double>(b.checksum);
  return std::fabs(first - second) <= 1e-3 * std::max(first, second);
}

}  // namespace

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

std::vector<Ray> incoherent_rays(const World& world, std::size_t count, std::uint64_t seed, float length) {
  std::vector<SurfaceSample> samples = area_uniform_samples(world, count, seed);
  for (std::size_t i = samples.size(); i > 1; --i)
    std::swap(samples[i - 1], samples[RandomStream(seed, shuffle_stage, i).next_bits() % i]);
  std::vector<Ray> rays;
  rays.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    RandomStream random(seed, direction_stage, i);
    const float first = random.next_float(), second = random.next_float();
    rays.push_back({world.ray_origin(samples[i]), 0.0F, cosine_direction(samples[i].normal, first, second), length});
  }
  return rays;
}

void race(benchmark::State& state, const char* ratio_name, const TraceRays& measured, const TraceRays& yardstick,
          std::span<const Ray> rays, int threads) {
  Run total, total_yardstick;
  std::vector<double> ratios;
  std::size_t block = 0;
  for (auto _ : state) {
    const auto part = rays.subspan(block * rays_per_block, rays_per_block);
    block = (block + 1) % (rays.size() / rays_per_block);
    Run run, run_yardstick;
    trace_block(yardstick, part, threads, run_yardstick);
    trace_block(measured, part, threads, run);
    trace_block(measured, part, threads, run);
    trace_block(yardstick, part, threads, run_yardstick);
    if (!agree(run, run_yardstick)) state.SkipWithError("the two do not meet the same surfaces");
    ratios.push_back(run_yardstick.seconds / run.seconds);
    total.seconds += run.seconds;
    total_yardstick.seconds += run_yardstick.seconds;
    state.SetIterationTime(run.seconds);
  }
  if (ratios.empty()) return;
  const double traced = 2.0 * static_cast<double>(rays_per_block) * static_cast<double>(ratios.size());
  state.counters[ratio_name] = median(ratios);
  state.counters["rays_per_second"] = traced / total.seconds;
  state.counters["yardstick_rays_per_second"] = traced / total_yardstick.seconds;
}

}  // namespace gibench::micro
