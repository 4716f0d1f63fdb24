/// Meshless radiosity, preparing and lighting, beside the bare loop's time for the rays of its gathers.
#include <benchmark/benchmark.h>

#include <utility>
#include <vector>

#include "bench/micro/cpu_clock.h"
#include "bench/micro/interleaved.h"
#include "bench/micro/many_triangles.h"
#include "bench/micro/method_timing.h"
#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "methods/registry.h"

namespace gibench::micro {
namespace {

/// A scene with the bare loop's rays in it: gathers, and rays to the lamp from as many points.
struct Arena {
  World world;
  BareEmbree bare;
  std::vector<Ray> gathers, shadow_rays;

  explicit Arena(Scene scene)
      : world(std::move(scene)),
        bare(world.scene()),
        gathers(cosine_rays(world, {.count = 1U << 18, .rays_per_point = 512})),
        shadow_rays(rays_to_lamp(world, {.count = 1U << 17, .seed = 2})) {}
};

const Arena& arena(bool many) {
  static const Arena spheres(bumpy_spheres()), box(made::box_scene());
  return many ? spheres : box;
}

/// With the paper's parameters, which are the defaults; `method_bytes` is what it holds at the end.
void meshless(benchmark::State& state, bool many) {
  const auto threads = static_cast<int>(state.range(0));
  const Arena& in = arena(many);
  const MethodEntry& entry = find_method("meshless");
  time_against_bare(state, in.bare, in.gathers, in.shadow_rays, threads, [&] {
    const auto method = make_session(entry, Parameters(entry.schema, {}));
    Task task({.seed = 1, .threads = threads, .cancel = {}, .on_progress = {}});
    const EffectPlan plan = plan_effects(analyse_effects(in.world), method->capabilities().effects);
    const double start = process_seconds();
    GIBENCH_CHECK(succeeded(method->prepare(in.world, plan, task).termination), "it was not prepared");
    GIBENCH_CHECK(succeeded(method->light(Lighting::of(in.world.scene()), task).termination), "it was not lit");
    const double seconds = process_seconds() - start;
    state.counters["method_bytes"] = static_cast<double>(method->bytes());
    return Work{seconds, task.counters()};
  });
}
BENCHMARK_CAPTURE(meshless, spheres, true)->Arg(1)->Arg(2)->ArgName("threads")->UseManualTime()->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(meshless, box, false)->Arg(1)->Arg(2)->ArgName("threads")->UseManualTime()->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace gibench::micro
