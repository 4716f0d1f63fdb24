/// A plan is obeyed: what it leaves out costs nothing and is not in the answer.
#include <fmt/format.h>

#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "common/light_paths/automaton.h"
#include "common/method/method_session.h"
#include "common/scene/made_scenes.h"
#include "tests/contract/compare.h"
#include "tests/contract/contract.h"
#include "tests/contract/run.h"
#include "tests/contract/scenes.h"

namespace gibench::contract {

namespace {

/// What one run counted, all stages together, and its answer.
struct CountedRun {
  Answer answer;
  Counters before_shading, counters;
  std::uint64_t rays() const { return counters["closest_hit_rays"] + counters["occlusion_rays"]; }
  std::uint64_t rays_before_shading() const { return before_shading["closest_hit_rays"] + before_shading["occlusion_rays"]; }
};

CountedRun counted_run(const MethodEntry& entry, const World& world, const RunOptions& options = {}) {
  Run run(entry, world, options);
  Task task = run.task();
  require_success(run.prepare(task), "prepare");
  require_success(run.light(Lighting::of(world.scene()), task), "light");
  CountedRun result;
  result.before_shading = task.counters();
  require_success(run.shade(plainest_quantity(entry), samples_of(world), result.answer, task), "shade");
  result.counters = task.counters();
  return result;
}

/// A cube whose walls face inwards, part of its ceiling a lamp, a point light in it.
Scene convex_room() {
  made::SceneBuilder builder;
  const std::uint32_t white = builder.diffuse("white", {0.6F, 0.5F, 0.4F}), lamp = builder.diffuse("lamp", Rgb(0.2F), Rgb(3.0F));
  builder.quad("floor", white, {Vec3{0, 0, 0}, {0, 0, 1}, {1, 0, 1}, {1, 0, 0}});
  builder.quad("ceiling", white, {Vec3{0, 1, 0}, {0.6F, 1, 0}, {0.6F, 1, 1}, {0, 1, 1}});
  builder.quad("lamp", lamp, {Vec3{0.6F, 1, 0}, {1, 1, 0}, {1, 1, 1}, {0.6F, 1, 1}});
  builder.quad("back", white, {Vec3{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}});
  builder.quad("front", white, {Vec3{0, 0, 1}, {0, 1, 1}, {1, 1, 1}, {1, 0, 1}});
  builder.quad("left", white, {Vec3{0, 0, 0}, {0, 1, 0}, {0, 1, 1}, {0, 0, 1}});
  builder.quad("right", white, {Vec3{1, 0, 0}, {1, 0, 1}, {1, 1, 1}, {1, 1, 0}});
  builder.light(PointLight{{0.3F, 0.7F, 0.4F}, {0.5F, 0.6F, 0.7F}});
  return builder.build("convex room");
}

}  // namespace

void verify_a_convex_room_needs_no_visibility_rays(const MethodEntry& entry) {
  const World world(convex_room());
  const CountedRun run = counted_run(entry, world), forced = counted_run(entry, world, {.forced = {Effect::occlusion}});
  if (const std::uint64_t rays = run.counters["occlusion_rays"]; rays > 0)
    throw Violation(fmt::format("{} occlusion rays were traced in a convex room with its lights inside", rays));
  require_same_means(forced.answer, run.answer, samples_of(world), slack_of(entry),
                     "a convex room with and without visibility rays");
}

void verify_no_light_needs_no_work(const MethodEntry& entry) {
  const World world(dark_box());
  const CountedRun run = counted_run(entry, world);
  require_black(run.answer.direct, "direct light of a scene without lights");
  require_black(run.answer.indirect, "indirect light of a scene without lights");
  if (run.rays() > 0) throw Violation(fmt::format("{} rays were traced in a scene without lights", run.rays()));
}

void verify_black_walls_need_no_indirect_work(const MethodEntry& entry) {
  const World black(black_box());
  if (const std::uint64_t rays = counted_run(entry, black).rays_before_shading(); rays > 0)
    throw Violation(fmt::format("{} rays were traced for indirect light between black walls", rays));
}

void verify_what_is_not_allowed_is_not_computed(const MethodEntry& entry) {
  const World world(plain_box());
  const auto samples = samples_of(world);
  const auto answer_with = [&](const EffectSet& allowed) {
    const auto method = make_session(entry, Parameters(entry.schema, entry.quick));
    const EffectPlan plan =
        plan_effects(analyse_effects(world, PlanLimits{allowed, {}, 0.0, {}}), effects_of(method->capabilities()));
    Task task({.seed = 7, .threads = 2, .cancel = {}, .on_progress = {}});
    require_success(method->prepare(world, plan, task), "prepare");
    require_success(method->light(Lighting::of(world.scene()), task), "light");
    Answer answer{std::vector<Rgb>(samples.size()), std::vector<Rgb>(samples.size())};
    std::vector<Vec3> toward_viewer;
    if (plainest_quantity(entry) == Quantity::radiance)
      for (const SurfaceSample& sample : samples) toward_viewer.push_back(sample.normal);
    require_success(
        method->shade({plainest_quantity(entry), samples, toward_viewer}, {answer.direct, answer.indirect, {}, {}, {}}, task),
        "shade");
    return answer;
  };
  require_black(answer_with({Effect::direct}).indirect, "indirect light where direct light alone is allowed");
  const Answer indirect = answer_with({Effect::diffuse_indirect});
  require_black(indirect.direct, "direct light where indirect light alone is allowed");
  const Answer nothing = answer_with({});
  require_black(nothing.direct, "direct light where nothing is allowed");
  require_black(nothing.indirect, "indirect light where nothing is allowed");
}

void verify_light_paths_are_told(const MethodEntry& entry) {
  const World world(plain_box());
  const auto method = make_session(entry, Parameters(entry.schema, entry.quick));
  const auto automaton_of = [&](const std::string& paths) {
    try {
      return PathAutomaton(paths);
    } catch (const InputError& error) {
      throw Violation(fmt::format("its light paths are not an expression: {}", error.what()));
    }
  };
  automaton_of(entry.light_paths);
  for (const std::optional<int> bounces : {std::optional<int>(), std::optional(0), std::optional(2)}) {
    const EffectPlan plan = plan_effects(analyse_effects(world, bounces), effects_of(method->capabilities()));
    const PathAutomaton own = automaton_of(method->light_paths(plan));
    std::vector<PathEvent> path{PathEvent::camera, PathEvent::diffuse_reflection};
    for (int reflections = 0; reflections < 5; ++reflections, path.push_back(PathEvent::diffuse_reflection)) {
      std::vector<PathEvent> whole = path;
      whole.push_back(PathEvent::emitter);
      const bool asked = !bounces || reflections <= *bounces,
                 simulated = reflections == 0 || plan.simulates(Effect::diffuse_indirect);
      if (own.matches(whole) && !asked)
        throw Violation(fmt::format("its light paths {} hold more than {} bounces", method->light_paths(plan), *bounces));
      if (!own.matches(whole) && asked && simulated)
        throw Violation(fmt::format("its light paths {} lack diffuse paths that it simulates", method->light_paths(plan)));
    }
  }
}

}  // namespace gibench::contract
