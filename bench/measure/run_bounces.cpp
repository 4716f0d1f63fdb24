#include "bench/measure/run_bounces.h"

#include "bench/measure/run_errors.h"
#include "common/effects/plan_paths.h"
#include "common/light_paths/automaton.h"

namespace gibench {

namespace {

Answers difference(Answers more, const Answers& less) {
  for (std::size_t i = 0; i < more.direct.size(); ++i) more.direct[i] -= less.direct[i];
  for (std::size_t i = 0; i < more.indirect.size(); ++i) more.indirect[i] -= less.indirect[i];
  return more;
}

/// The method with at most so many reflections; no log, no progress.
RunOutcome bounded_run(const LoadedScene& scene, const MethodChoice& choice, MeasuringOptions measuring,
                       const PlanOptions& options, WorkOptions common, int bounces) {
  measuring.bounces = bounces;
  common.quiet = true;
  RunLog log({}, true);
  return run_method(scene, choice, measuring, options, common, log);
}

}  // namespace

std::vector<BounceErrors> errors_per_bounce(const LoadedScene& scene, const MethodChoice& choice,
                                            const MeasuringOptions& measuring, const PlanOptions& options,
                                            const WorkOptions& common, int last, const Exposure& exposure,
                                            const FindReference& find, std::vector<std::string>& lacking) {
  const SceneEffects effects = analyse_effects(*scene.world, limits_of(options, measuring.bounces));
  const PlannedMethod planned = plan_method(effects, choice, options.light_paths);
  std::vector<BounceErrors> errors;
  std::optional<RunOutcome> before;
  for (int bounce = 0; bounce <= last; ++bounce) {
    const BounceRange range{bounce, bounce};
    const std::string all_paths = light_paths_of({}, false, range), own_paths = planned.method->light_paths(planned.plan, range);
    const bool complete = equivalent(PathAutomaton(all_paths).restricted_to(effects.events),
                                     PathAutomaton(own_paths).restricted_to(effects.events));
    RunOutcome now = bounded_run(scene, choice, measuring, options, common, bounce);
    Answers surface = before ? difference(now.surface, before->surface) : now.surface;
    std::optional<Answers> image = now.image;
    if (image && before) image = difference(*image, *before->image);
    before = std::move(now);
    const std::optional<Reference> all = find(all_paths), own = complete ? all : find(own_paths);
    if (!all) lacking.push_back(all_paths);
    if (!own && !complete) lacking.push_back(own_paths);
    if (!all || !own) continue;
    BounceErrors entry{bounce, std::nullopt, errors_against(*own, surface, image, exposure)};
    if (!complete) entry.model = model_errors(*all, *own, exposure);
    errors.push_back(std::move(entry));
  }
  return errors;
}

}  // namespace gibench
