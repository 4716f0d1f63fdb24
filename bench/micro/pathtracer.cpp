/// The path tracer's rays per second beside the bare loop's, in the same scene.
#include <benchmark/benchmark.h>

#include <string>
#include <utility>
#include <vector>

#include "bench/micro/cpu_clock.h"
#include "bench/micro/interleaved.h"
#include "bench/micro/many_triangles.h"
#include "bench/micro/method_timing.h"
#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "common/geometry/surface_sampling.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/registry.h"

namespace gibench::micro {
namespace {

constexpr std::size_t path_count = 1U << 16;  // shared by values of irradiance

/// A scene, and the bare loop's rays in it.
struct Arena {
  World world;
  BareEmbree bare;
  std::vector<Ray> rays, shadow_rays;

  explicit Arena(Scene scene)
      : world(std::move(scene)),
        bare(world.scene()),
        rays(cosine_rays(world, {.count = 1U << 17})),
        shadow_rays(rays_to_lamp(world, {.count = 1U << 17, .seed = 2})) {}
};

const Arena& arena(bool many) {
  static const Arena spheres(bumpy_spheres()), box(made::box_scene());
  return many ? spheres : box;
}

void path_tracer(benchmark::State& state, bool many) {
  const auto threads = static_cast<int>(state.range(0));
  const std::int64_t paths_each = state.range(1);
  const Arena& in = arena(many);
  const auto samples = area_uniform_samples(in.world, path_count / static_cast<std::size_t>(paths_each), 3);
  const MethodEntry& entry = find_method("pathtracer");
  const auto method = make_session(entry, Parameters(entry.schema, {{"samples", std::to_string(paths_each)}}));
  Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
  const EffectPlan plan = plan_effects(analyse_effects(in.world), method->capabilities().effects);
  method->prepare(in.world, plan, task);
  method->light(Lighting::of(in.world.scene()), task);
  std::vector<Rgb> direct(samples.size()), indirect(samples.size());
  time_against_bare(state, in.bare, in.rays, in.shadow_rays, threads, [&] {
    const double start = process_seconds();
    const StageReport report = method->shade({Quantity::irradiance, samples, {}}, {direct, indirect, {}, {}, {}}, task);
    GIBENCH_CHECK(succeeded(report.termination), "a path tracer that failed is not worth timing");
    return Work{process_seconds() - start, report.counters};
  });
}
void threads_and_samples(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"threads", "samples"})->Args({1, 64})->Args({2, 64})->Args({1, 1})->Args({2, 1});
  benchmark->UseManualTime()->Unit(benchmark::kMillisecond);
}
BENCHMARK_CAPTURE(path_tracer, spheres, true)->Apply(threads_and_samples);
BENCHMARK_CAPTURE(path_tracer, box, false)->Apply(threads_and_samples);

}  // namespace
}  // namespace gibench::micro
