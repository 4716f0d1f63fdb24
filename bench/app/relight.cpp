#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/app/call_tree.h"
#include "bench/app/options.h"
#include "bench/app/print_json.h"
#include "bench/app/value_kinds.h"
#include "bench/app/verbs.h"
#include "bench/measure/cancellation.h"
#include "bench/measure/moving_lights.h"
#include "bench/measure/reference_making.h"
#include "bench/measure/run_method.h"
#include "bench/record/relight_record.h"
#include "common/core/atomic_file.h"
#include "common/core/error.h"
#include "common/metrics/errors.h"
#include "common/spaces/surface_domain.h"

namespace gibench {

namespace {

struct RelightCall {
  SceneOptions scene;
  MethodOptions method;
  std::filesystem::path lights, out;
  std::optional<int> bounces;
  RelightOptions relight;
};

constexpr int reference_replicas = 8;

Lighting lighting_of(const LightsFrame& frame) {
  Lighting lighting{frame.lights, {}};
  for (const Material& material : frame.materials) lighting.emission.push_back(material.emission);
  return lighting;
}

/// Of the mean over all replicates, channels together.
double root_mean_variance(const Replicas& replicas) {
  double sum = 0.0;
  for (const Rgb& v : replicas.variance_of_mean()) sum += static_cast<double>(v.r + v.g + v.b) / 3.0;
  return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, replicas.size())));
}

/// Whatever the lights are: what is sealed off from them may change from frame to frame.
SurfaceDomain domain_of(const Scene& scene) {
  const auto kind = scene.cameras.empty() ? SurfaceDomain::Kind::whole : SurfaceDomain::Kind::seen;
  return {kind, {}};
}

class Relighter {
 public:
  Relighter(const RelightOptions& options, std::optional<int> bounces, const CommonOptions& common, const MethodChoice& choice,
            std::unique_ptr<World> world)
      : options_(options),
        common_(common),
        choice_(choice),
        task_(make_task(common, world->scene().name + ", " + choice.entry->name)),
        world_(std::move(world)) {
    measuring_.bounces = bounces;
    question_ = {path_class(bounces), common.seed, options.surface_samples,
                 std::nullopt,        1,           to_string(domain_of(world_->scene()))};
    points_ = measuring_points(*world_, question_, common.threads);
    if (options.compared_samples > 0) question_.surface_samples = options.compared_samples;
  }

  void prepare(RunLog& log) { lit_ = prepare_and_light(*world_, choice_, PlanOptions{}, measuring_.bounces, task_, log); }
  double prepare_seconds() const { return lit_.stages.front().report.seconds; }
  const Scene& scene() const { return world_->scene(); }

  RelitFrame relight(const LightsFrame& frame) {
    RelitFrame record;
    record.at = frame.at;
    const Lighting lighting = lighting_of(frame);
    if (frame.switched.empty()) keep(record, lit_.method->light(lighting, task_));
    else switch_materials(frame, lighting, record);
    const Answers answers = shade_surface(*lit_.method, points_, task_);
    require_success(answers.report, choice_.entry->name, "shade");
    record.shade_seconds = answers.report.seconds;
    if (options_.reference_samples == 0) return record;
    if (question_.surface_samples == points_.surface.size()) {
      compare(frame, answers, record);
      return record;
    }
    const Answers compared = shade_surface(*lit_.method, measuring_points(*world_, question_, common_.threads), task_);
    require_success(compared.report, choice_.entry->name, "shade");
    compare(frame, compared, record);
    return record;
  }

 private:
  void keep(RelitFrame& record, const StageReport& report) {
    require_success(report, choice_.entry->name, fmt::format("relighting at {:.3g}", record.at));
    record.relight_seconds += report.seconds;
    record.termination = report.termination;
  }

  /// The same geometry with the frame's lights and materials.
  Scene scene_at(const LightsFrame& frame) const {
    Scene scene = world_->scene();
    scene.lights = frame.lights;
    scene.materials = frame.materials;
    return scene;
  }

  void switch_materials(const LightsFrame& frame, const Lighting& lighting, RelitFrame& record) {
    auto after = std::make_unique<World>(scene_at(frame), *world_);
    for (const MaterialEdit& edit : frame.switched) {
      keep(record, lit_.method->edit(edit, *after, lighting, task_));
      record.switched.push_back(edit.material);
    }
    world_ = std::move(after);
  }

  void compare(const LightsFrame& frame, const Answers& answers, RelitFrame& record) const {
    LoadedScene lit{std::make_unique<World>(scene_at(frame), *world_)};
    Reference reference;
    reference.question = question_;
    CommonOptions quietly = common_;
    quietly.quiet = true;
    extend_reference(lit, measuring_, {.count = reference_replicas}, {options_.reference_samples, std::nullopt, std::nullopt},
                     quietly, reference, [](const Reference&) {});
    record.errors[Component::direct] = value_errors(answers.direct, reference.surface.direct);
    record.errors[Component::indirect] = value_errors(answers.indirect, reference.surface.indirect);
    const Replicas total = Replicas::sum(reference.surface.direct, reference.surface.indirect);
    record.errors[Component::total] = value_errors(answers.total(), total);
    const double paths = static_cast<double>(options_.reference_samples) * reference_replicas;
    const PathTraced compared{reference.seconds, root_mean_variance(reference.surface.indirect), paths};
    record.reference = at_as_many_points(compared, question_.surface_samples, points_.surface.size());
    record.path_tracing = path_tracing_seconds(*record.reference, record.errors[Component::indirect]["rmse"]);
  }

  const RelightOptions& options_;
  const CommonOptions& common_;
  const MethodChoice& choice_;
  Task task_;
  std::unique_ptr<World> world_;
  MeasuringOptions measuring_;
  ReferenceQuestion question_;
  MeasuringPoints points_;
  LitMethod lit_;
};

/// "3.1 [2.5, 4.2]"; "at least 2.5" or "at most 4.2" where the noise hides the rest.
std::string bounded_text(const Bounded& number) {
  const auto text = [](const std::optional<double>& end) { return end ? fmt::format("{:.3g}", *end) : std::string("–"); };
  if (number.value) return fmt::format("{} [{}, {}]", text(number.value), text(number.low), text(number.high));
  if (number.low) return "at least " + text(number.low);
  return number.high ? "at most " + text(number.high) : "not known";
}

void print_summary(const RelightSummary& summary) {
  fmt::print("{} frames after {:.3f} s of preparing\n", summary.frames, summary.prepare_seconds);
  fmt::print("  median frame   {:.4f} s relighting, {:.4f} s shading\n", summary.relight_seconds, summary.shade_seconds);
  if (!summary.path_tracing_seconds) return;
  fmt::print("  path tracing   {} s at equal indirect error\n", bounded_text(*summary.path_tracing_seconds));
  fmt::print("                 {} times the frame\n", bounded_text(*summary.times_cheaper));
  fmt::print("  preparing      is paid for after this many frames: {}\n", bounded_text(*summary.frames_that_pay));
}

ExitStatus relight(const RelightCall& options, const CommonOptions& common) {
  const MethodChoice choice = choose_method(options.method);
  require_relighting(choice);
  require_irradiance(choice);
  LoadedScene loaded = load_world(options.scene, common.threads);
  const std::vector<LightsFrame> frames = read_moving_lights(options.lights, loaded.scene(), options.relight.frames);
  RunLog log({}, common.quiet);
  Relighter relighter(options.relight, options.bounces, common, choice, std::move(loaded.world));
  relighter.prepare(log);
  RelightRecord record{relighter.scene().name, choice.entry->name, common.seed, choice.parameters.values(), {}, {}};
  for (const LightsFrame& frame : frames) {
    record.frames.push_back(relighter.relight(frame));
    stop_if_cancelled();
  }
  record.summary = summarise(relighter.prepare_seconds(), record.frames);
  if (!options.out.empty()) write_file_atomically(options.out, to_json(record).dump(2) + "\n");
  if (common.json) print_json(to_json(record));
  else if (!common.quiet) print_summary(record.summary);
  return ExitStatus::done;
}

}  // namespace

void add_relight(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "relight", "Moves lights and switches materials: time and error of each relit frame");
  verb->group(verb_group::computing);
  set_pages(*verb, {"scenes/README.md", "docs/files.md"});
  const auto options = std::make_shared<RelightCall>();
  add_scene_options(*verb, options->scene);
  add_method_options(*verb, options->method);
  verb->add_option("--lights", options->lights, "JSON file of the moving lights; see scenes/README.md")
      ->type_name(value_kind::file)
      ->required();
  add_relight_options(*verb, options->relight);
  verb->add_option("--out", options->out, "JSON file for the frames; with --json they go to stdout")->type_name(value_kind::file);
  add_bounces_option(*verb, options->bounces);
  verb->callback([&call, options] { call.action = [&call, options] { return relight(*options, call.common); }; });
}

}  // namespace gibench
