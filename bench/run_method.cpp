#include "bench/run_method.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bench/cancellation.h"
#include "bench/progress_bar.h"
#include "common/core/error.h"
#include "common/effects/scene_effects.h"
#include "methods/registry.h"

namespace gibench {

namespace {

void log_stage(const StageRecord& stage, RunLog& log) {
  std::string counts;
  for (const auto& [name, value] : stage.report.counters.values()) counts += fmt::format(", {} {}", value, name);
  log.info(fmt::format("{}: {} after {:.4f} s{}{}{}", stage.stage, to_string(stage.report.termination), stage.report.seconds,
                       counts, stage.report.message.empty() ? "" : "; ", stage.report.message));
  for (const ProgressPoint& point : stage.report.history)
    if (point.residual >= 0.0) log.info(fmt::format("{}: {}: residual {:.3e}", stage.stage, point.step, point.residual));
}

std::string names_of(const EffectSet& effects) {
  std::vector<std::string> names;
  for (const Effect effect : effects) names.emplace_back(to_string(effect));
  return fmt::format("{}", fmt::join(names, ", "));
}

std::vector<std::string> warnings_of(const Scene& scene, const EffectPlan& plan, const std::string& method) {
  std::vector<std::string> warnings = scene.warnings;
  if (!plan.missing.empty())
    warnings.push_back(fmt::format("{} cannot simulate what the scene calls for: {}", method, names_of(plan.missing)));
  return warnings;
}

std::vector<std::string> completed_components(const Capabilities& can) {
  std::vector<std::string> completed;
  if (!can.direct) completed.emplace_back("direct");
  return completed;
}

}  // namespace

MethodChoice choose_method(const std::string& name, const std::vector<std::string>& settings) {
  const MethodEntry& entry = find_method(name);
  std::vector<std::pair<std::string, std::string>> pairs;
  for (const std::string& setting : settings) {
    const std::size_t equals = setting.find('=');
    if (equals == std::string::npos || equals == 0)
      throw InputError("--set", fmt::format("'{}' is no setting", setting), "write --set name=value");
    pairs.emplace_back(setting.substr(0, equals), setting.substr(equals + 1));
  }
  return {&entry, Parameters(entry.schema, pairs)};
}

Task make_task(const CommonOptions& common, const std::string& title) {
  TaskSettings settings;
  settings.seed = common.seed;
  settings.threads = common.threads;
  settings.cancel = cancellation();
  settings.on_progress = [bar = std::make_shared<ProgressBar>(title, common.quiet)](const ProgressPoint& point) {
    bar->update(point.step, point.done);
  };
  return Task(std::move(settings));
}

LitMethod prepare_and_light(const World& world, const MethodChoice& choice, std::optional<int> bounces, Task& task, RunLog& log) {
  const std::string& name = choice.entry->name;
  LitMethod lit;
  lit.method = choice.entry->make(choice.parameters);
  if (const auto why = lit.method->refusal(world.scene()))
    throw WorkError(fmt::format("{}{} cannot work on scene '{}': {}", refusal_prefix, name, world.scene().name, *why));
  lit.plan = plan_effects(analyse_effects(world, bounces), lit.method->capabilities().effects);
  log.info(fmt::format("{} simulates {}", name, lit.plan.simulated.empty() ? "nothing" : names_of(lit.plan.simulated)));
  for (const SkippedEffect& effect : lit.plan.skipped)
    log.info(fmt::format("skipped {}: {}", to_string(effect.effect), effect.why));
  lit.stages.push_back({"prepare", lit.method->prepare(world, lit.plan, task)});
  log_stage(lit.stages.back(), log);
  require_success(lit.stages.back().report, name, "prepare");
  lit.stages.push_back({"light", lit.method->light(Lighting::of(world.scene()), task)});
  log_stage(lit.stages.back(), log);
  require_success(lit.stages.back().report, name, "light");
  return lit;
}

RunOutcome run_method(const LoadedScene& scene, const MethodChoice& choice, const MeasuringOptions& measuring,
                      const CommonOptions& common, RunLog& log) {
  const World& world = *scene.world;
  const std::string& name = choice.entry->name;
  const int threads = common.threads > 0 ? common.threads : hardware_threads();
  const ReferenceQuestion question = question_of(scene.scene(), measuring);
  log.info(fmt::format("scene '{}': {} triangles, read in {:.4f} s; {}, seed {}, {} threads", scene.scene().name,
                       scene.scene().triangles.size(), scene.seconds, name, common.seed, threads));
  Task task = make_task(common, fmt::format("{}, {}", scene.scene().name, name));
  LitMethod lit = prepare_and_light(world, choice, measuring.bounces, task, log);
  const MeasuringPoints points = measuring_points(world, question, common.threads);
  RunOutcome outcome{{}, shade_surface(*lit.method, points, task), std::nullopt};
  const auto keep = [&](const char* stage, const StageReport& report) {
    lit.stages.push_back({stage, report});
    log_stage(lit.stages.back(), log);
    require_success(report, name, stage);
  };
  keep("shade_surface", outcome.surface.report);
  if (points.camera) {
    outcome.image = shade_image(*lit.method, points, task);
    keep("shade_image", outcome.image->report);
  }
  RunRecord& record = outcome.record;
  record.scene = scene.scene().name, record.method = name, record.parameters = choice.parameters.values();
  record.seed = common.seed, record.threads = threads, record.question = question, record.plan = lit.plan;
  record.completed = completed_components(lit.method->capabilities());
  record.load_seconds = scene.seconds;
  record.stages = std::move(lit.stages);
  record.method_bytes = lit.method->bytes();
  record.counters = task.counters();
  record.warnings = warnings_of(scene.scene(), lit.plan, name);
  return outcome;
}

}  // namespace gibench
