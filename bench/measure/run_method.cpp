#include "bench/measure/run_method.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/measure/black_backs.h"
#include "bench/measure/cancellation.h"
#include "common/core/error.h"
#include "common/light_paths/automaton.h"
#include "methods/registry.h"

namespace gibench {

namespace {

constexpr int most_compared = 256;  // bounces; an expression writes no larger bound

void log_stage(const StageRecord& stage, RunLog& log) {
  std::string counts;
  for (const auto& [name, value] : stage.report.counters.values()) counts += fmt::format(", {} {}", value, name);
  log.info(fmt::format("{}: {} after {:.4f} s{}{}{}", to_string(stage.stage), to_string(stage.report.termination),
                       stage.report.seconds, counts, stage.report.message.empty() ? "" : "; ", stage.report.message));
  for (const ProgressPoint& point : stage.report.history)
    if (point.residual >= 0.0)
      log.info(fmt::format("{}: {}: residual {:.3e}", to_string(stage.stage), point.step, point.residual));
}

std::vector<std::string> warnings_of(const Scene& scene, const EffectPlan& plan, const std::string& method) {
  std::vector<std::string> warnings = scene.warnings;
  if (!plan.missing.empty())
    warnings.push_back(fmt::format("{} cannot simulate what the scene calls for: {}", method, names_of(plan.missing)));
  if (plan.unlit) warnings.push_back("nothing to simulate: " + plan.skipped.front().why);
  else if (!plan.simulates(Effect::direct) && plan.skips_indirect())
    warnings.emplace_back("nothing to simulate: the plan leaves neither direct nor indirect light");
  return warnings;
}

MeasuredAt measured_at(const ReferenceQuestion& question) {
  MeasuredAt at{question.surface_samples, question.seed, std::nullopt, question.pixel_samples, question.surface_domain, {}};
  if (question.camera) at.camera = {question.camera->name, question.camera->width, question.camera->height};
  return at;
}

std::vector<Component> completed_components(const Capabilities& can) {
  std::vector<Component> completed;
  if (!can.direct) completed.push_back(Component::direct);
  return completed;
}

/// A method that can tell the variance of its values draws every value independently, also where it was not set to tell it.
bool has_noise_of_points(const MethodEntry& entry) {
  return make_session(entry, Parameters(entry.schema, {}))->knows_variance(Quantity::irradiance);
}

}  // namespace

const MethodEntry& method_named(const std::string& name, const std::string& place) { return find_method(name, place); }

MethodChoice choose_method(const std::string& name, const std::vector<std::string>& settings, const std::string& preset) {
  const MethodEntry& entry = find_method(name);
  SettingTexts pairs;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError("--set", fmt::format("'{}' is not a setting", setting), "write --set name=value");
    pairs.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  return {&entry, Parameters(entry.schema, with_preset(entry.presets, preset, pairs))};
}

void require_relighting(const MethodChoice& choice, const std::string& place) {
  if (make_session(*choice.entry, choice.parameters)->capabilities().relights) return;
  std::string known;
  for (const MethodEntry& entry : all_methods())
    if (make_session(entry, Parameters(entry.schema, {}))->capabilities().relights)
      known += (known.empty() ? "" : ", ") + entry.name;
  throw InputError(place, fmt::format("{} does not relight: new lights cost it as much as a new scene", choice.entry->name),
                   known.empty() ? "no method does" : "known to relight: " + known);
}

void require_irradiance(const MethodChoice& choice) {
  if (make_session(*choice.entry, choice.parameters)->answers(Quantity::irradiance)) return;
  throw MethodRefusal(fmt::format("refused: {} does not answer irradiance, in which methods are compared at surface samples",
                                  choice.entry->name));
}

Task make_task(const WorkOptions& common, const std::string& title) {
  TaskSettings settings;
  settings.seed = common.seed;
  settings.threads = common.threads;
  settings.cancel = cancellation();
  settings.on_progress = [shown = common.progress_of(title)](const ProgressPoint& point) {
    shown->update(point.step, point.done);
  };
  return Task(std::move(settings));
}

PlannedMethod plan_method(const SceneEffects& effects, const MethodChoice& choice, const std::string& light_paths) {
  PlannedMethod planned{make_session(*choice.entry, choice.parameters), {}, {}, false};
  const Capabilities can = planned.method->capabilities();
  if (!light_paths.empty() && !can.any_light_paths)
    throw InputError("--light-paths", fmt::format("{} cannot choose its light paths", choice.entry->name),
                     "leave it out, or choose what it simulates by --effects");
  planned.plan = plan_effects(effects, effects_of(can));
  planned.plan.light_paths = light_paths;
  planned.light_paths = planned.method->light_paths(planned.plan);
  const PathAutomaton asked(
      path_class(effects.limits.bounces.value_or(0) > most_compared ? std::nullopt : effects.limits.bounces));
  planned.complete =
      equivalent(PathAutomaton(planned.light_paths).restricted_to(effects.events), asked.restricted_to(effects.events));
  return planned;
}

bool LitMethod::shows_background() const {
  return PathAutomaton(light_paths).accepts(PathAutomaton::start, PathEvent::background);
}

LitMethod prepare_and_light(const World& world, const MethodChoice& choice, const PlanOptions& options,
                            std::optional<int> bounces, Task& task, RunLog& log) {
  const std::string& name = choice.entry->name;
  LitMethod lit;
  if (const auto why = make_session(*choice.entry, choice.parameters)->refusal(world.scene()))
    throw MethodRefusal(fmt::format("refused: {} cannot work on scene '{}': {}", name, world.scene().name, *why));
  static_cast<PlannedMethod&>(lit) =
      plan_method(analyse_effects(world, limits_of(options, bounces)), choice, options.light_paths);
  log.info(fmt::format("{} simulates {}; light paths {}", name,
                       lit.plan.simulated.empty() ? "nothing" : names_of(lit.plan.simulated), lit.light_paths));
  for (const SkippedEffect& effect : lit.plan.skipped)
    log.info(fmt::format("skipped {}: {}", to_string(effect.effect), effect.why));
  lit.stages.push_back({Stage::prepare, lit.method->prepare(world, lit.plan, task)});
  log_stage(lit.stages.back(), log);
  require_success(lit.stages.back().report, name, "prepare");
  lit.stages.push_back({Stage::light, lit.method->light(Lighting::of(world.scene()), task)});
  log_stage(lit.stages.back(), log);
  require_success(lit.stages.back().report, name, "light");
  return lit;
}

RunOutcome run_method(const LoadedScene& scene, const MethodChoice& choice, const MeasuringOptions& measuring,
                      const PlanOptions& options, const WorkOptions& common, RunLog& log) {
  require_irradiance(choice);
  const World& world = *scene.world;
  const std::string& name = choice.entry->name;
  const int threads = common.threads > 0 ? common.threads : hardware_threads();
  const ReferenceQuestion question = question_of(scene.scene(), measuring);
  log.info(fmt::format("scene '{}': {} triangles, read in {:.4f} s; {}, seed {}, {} threads", scene.scene().name,
                       scene.scene().triangles.size(), scene.seconds, name, common.seed, threads));
  Task task = make_task(common, fmt::format("{}, {}", scene.scene().name, name));
  // Before the method's work: where there is nothing to ask about, that is said at once.
  const MeasuringPoints points = measuring_points(world, question, common.threads);
  const std::string note = points.domain.note();
  if (!note.empty()) log.info("surface samples: " + note);
  LitMethod lit = prepare_and_light(world, choice, options, measuring.bounces, task, log);
  RunOutcome outcome{{}, shade_surface(*lit.method, points, task), std::nullopt};
  const auto keep = [&](Stage stage, const StageReport& report) {
    lit.stages.push_back({stage, report});
    log_stage(lit.stages.back(), log);
    require_success(report, name, to_string(stage));
  };
  keep(Stage::shade_surface, outcome.surface.report);
  if (points.camera) {
    outcome.image = shade_image(*lit.method, points, lit.shows_background(), task);
    keep(Stage::shade_image, outcome.image->report);
  }
  RunRecord& record = outcome.record;
  record.scene = scene.scene().name, record.method = name, record.parameters = choice.parameters.values();
  record.seed = common.seed, record.threads = threads, record.plan = lit.plan;
  record.origin = Origin::here();
  record.measured_at = measured_at(question);
  record.measured_at.sealed_share = points.domain.sealed_share;
  record.light_paths = lit.light_paths, record.complete = lit.complete;
  record.completed = completed_components(lit.method->capabilities());
  record.noise_of_points = has_noise_of_points(*choice.entry);
  record.load_seconds = scene.seconds;
  record.stages = std::move(lit.stages);
  record.method_bytes = lit.method->bytes();
  record.counters = task.counters();
  record.warnings = warnings_of(scene.scene(), lit.plan, name);
  if (points.camera)
    if (const std::string backs = warning_of_black_backs(world, *points.camera); !backs.empty()) record.warnings.push_back(backs);
  if (points.domain.nothing_reached) record.warnings.push_back("surface samples: " + note);
  return outcome;
}

void add_other_seeds(const LoadedScene& scene, const MethodChoice& choice, const MeasuringOptions& measuring,
                     const PlanOptions& options, const WorkOptions& common, int count, RunLog& log, RunOutcome& outcome) {
  if (count < 2) return;
  outcome.record.method_seeds = {common.seed};
  RunLog none({}, true);
  for (int k = 1; k < count; ++k) {
    WorkOptions again = common;
    again.seed = common.seed + static_cast<std::uint64_t>(k);
    stop_if_cancelled();
    log.info(fmt::format("again with seed {}, for the intervals", again.seed));
    RunOutcome other = run_method(scene, choice, measuring, options, again, none);
    other.surface.total_variance = {};
    if (other.image) other.image->total_variance = {};
    outcome.other_seeds.push_back({again.seed, std::move(other.surface), std::move(other.image)});
    outcome.record.method_seeds.push_back(again.seed);
  }
}

}  // namespace gibench
