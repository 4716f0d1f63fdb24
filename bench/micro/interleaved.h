/// Two ways of tracing the same rays, timed side by side: what a machine, busy or not, can say about a ratio.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "common/ray/ray.h"
#include "common/ray/world.h"

namespace gibench::micro {

/// Rays from area-uniform points of the surfaces in random order, cosine-distributed in no order.
struct RaySet {
  std::size_t count = 1U << 19;
  std::size_t rays_per_point = 1;  ///< 1: as incoherent as a path tracer's; 256: a gather's
  float length = std::numeric_limits<float>::infinity();
  std::uint64_t seed = 1;
};
std::vector<Ray> cosine_rays(const World& world, const RaySet& set);

/// Segments from such points to points of the emitting triangles, in no order: the shadow rays of next-event estimation.
std::vector<Ray> rays_to_lamp(const World& world, const RaySet& set);

double median(std::vector<double> values);

/// Traces these rays and gives a checksum of what they met.
using TraceRays = std::function<std::uint64_t(std::span<const Ray>)>;

/// Every iteration traces one block of the rays with both on `threads` threads, in the order A B B A or B A A B.
/// Times are CPU seconds inside the loops, summed over threads. Counters: `ratio_name` is the median over iterations of
/// the measured rays per CPU second over the yardstick's; `rays_per_cpu_second` and `yardstick_rays_per_cpu_second` are
/// totals. Ends with an error where the checksums differ by more than 1e-3.
void race(benchmark::State& state, const char* ratio_name, const TraceRays& measured, const TraceRays& yardstick,
          std::span<const Ray> rays, int threads);

}  // namespace gibench::micro
