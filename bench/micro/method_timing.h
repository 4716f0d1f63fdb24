/// A method's rays per CPU second beside those of the bare loop on rays of the same kinds.
#pragma once

#include <benchmark/benchmark.h>

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "bench/micro/bare_embree.h"
#include "common/core/counters.h"
#include "common/ray/ray.h"

namespace gibench::micro {

/// What a piece of a method's work took.
struct Work {
  double seconds = 0.0;  ///< of CPU, all threads
  Counters counters;     ///< with closest_hit_rays and occlusion_rays
};

/// Every iteration runs the bare loop over both kinds of rays, the method's work, and the bare loop again. Counters, as
/// medians over iterations: `over_bare_same_mix` is the time that the bare loop would take for as many closest hits and
/// occlusions as the work traced, over the time that it took; `over_bare_closest_hits` is its rays of both kinds per
/// second over the bare loop's closest hits per second. Besides `rays_per_cpu_second`, `closest_hit_rays` and
/// `occlusion_rays` of one run of the work.
void time_against_bare(benchmark::State& state, const BareEmbree& bare, std::span<const Ray> closest, std::span<const Ray> shadow,
                       int threads, const std::function<Work()>& work);

}  // namespace gibench::micro
