/// The path tracer's rays per second beside the bare loop's, in the same scene.
#include <benchmark/benchmark.h>

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

constexpr std::size_t value_count = 1024;  // values of irradiance, each of as many paths as the default says

/// A scene, the bare loop's rays in it, and where the path tracer is asked.
struct Arena {
  World world;
  BareEmbree bare;
  std::vector<Ray> rays, shadow_rays;
  std::vector<SurfaceSample> samples;

  explicit Arena(Scene scene)
      : world(std::move(scene)),
        bare(world.scene()),
        rays(cosine_rays(world, {.count = 1U << 17})),
        shadow_rays(rays_to_lamp(world, {.count = 1U << 17, .seed = 2})),
        samples(area_uniform_samples(world, value_count, 3)) {}
};

const Arena& arena(bool many) {
  static const Arena spheres(bumpy_spheres()), box(made::box_scene());
  return many ? spheres : box;
}

void path_tracer(benchmark::State& state, bool many) {
  const auto threads = static_cast<int>(state.range(0));
  const Arena& in = arena(many);
  const MethodEntry& entry = find_method("pathtracer");
  const auto method = make_session(entry, Parameters(entry.schema, {}));
  Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
  const EffectPlan plan = plan_effects(analyse_effects(in.world), method->capabilities().effects);
  method->prepare(in.world, plan, task);
  method->light(Lighting::of(in.world.scene()), task);
  std::vector<Rgb> direct(in.samples.size()), indirect(in.samples.size());
  time_against_bare(state, in.bare, in.rays, in.shadow_rays, threads, [&] {
    const double start = process_seconds();
    const StageReport report = method->shade({Quantity::irradiance, in.samples, {}}, {direct, indirect, {}, {}, {}}, task);
    GIBENCH_CHECK(succeeded(report.termination), "a path tracer that failed is not worth timing");
    return Work{process_seconds() - start, report.counters};
  });
}
BENCHMARK_CAPTURE(path_tracer, spheres, true)->Arg(1)->Arg(2)->ArgName("threads")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(path_tracer, box, false)->Arg(1)->Arg(2)->ArgName("threads")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gibench::micro
