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
#include "bench/measure/memory_needs.h"
#include "bench/measure/picture_library.h"
#include "bench/measure/reference_search.h"
#include "bench/measure/result_files.h"
#include "bench/measure/run_bounces.h"
#include "bench/measure/run_errors.h"
#include "bench/measure/run_method.h"
#include "bench/record/output_folder.h"
#include "common/core/available_memory.h"
#include "common/core/error.h"
#include "common/metrics/metric_table.h"

namespace gibench {

namespace {

struct RunOptions {
  SceneOptions scene;
  MethodOptions method;
  MeasuringOptions measuring;
  PlanOptions plan;
  std::optional<int> per_bounce;
  int method_seeds = 1;
  std::string reference = "auto", store = "references";
  std::vector<std::string> reference_states;
  std::filesystem::path out;
  bool force = false;
};

/// Whether errors may be taken against it.
bool is_wanted(const RunOptions& options, const Scene& scene, const Reference& reference) {
  const auto& states = options.reference_states;
  return states.empty() || std::find(states.begin(), states.end(), facts_of(scene, reference).state()) != states.end();
}

/// The stored reference; if there is none, a warning with the command that makes it. Never makes one itself.
std::optional<Reference> stored_reference(const RunOptions& options, const Scene& scene, const ReferenceSearch& search,
                                          std::vector<std::string>& warnings) {
  if (options.reference == "none") return std::nullopt;
  const bool named = options.reference != "auto";
  const std::string folder = named ? options.reference : options.store;
  auto found = search.find(question_of(scene, options.measuring));
  const std::string command =
      fmt::format("gibench reference {} --references {}{}", options.scene.name, folder, command_line_of(options.measuring));
  if (found && !is_wanted(options, scene, *found))
    throw InputError(
        "--reference-state",
        fmt::format("the stored reference is in the state {}, not one of those named", facts_of(scene, *found).state()),
        "name it, or leave the option out");
  if (!found && (named || !options.reference_states.empty()))
    throw InputError("--reference " + folder, "holds no reference of this scene and question", "make it: " + command);
  if (!found) warnings.push_back("no stored reference, so no errors; make one: " + command);
  return found;
}

std::string store_of(const RunOptions& options) { return options.reference == "auto" ? options.store : options.reference; }

/// The command that makes the reference of some light paths, asked at the same places.
std::string command_for(const RunOptions& options, const std::string& light_paths) {
  MeasuringOptions measuring = options.measuring;
  measuring.light_paths = light_paths, measuring.bounces.reset();
  return fmt::format("gibench reference {} --references {}{}", options.scene.name, store_of(options), command_line_of(measuring));
}

std::optional<Reference> reference_of(const RunOptions& options, const Scene& scene, const ReferenceSearch& search,
                                      const std::string& light_paths) {
  auto found = search.find(restricted_to(question_of(scene, options.measuring), light_paths));
  return found && is_wanted(options, scene, *found) ? std::move(found) : std::nullopt;
}

/// Model error (of the paths that a method lacks) and discretisation error (on those that it has).
void split_errors(const RunOptions& options, const Scene& scene, const ReferenceSearch& search, const Reference& all,
                  const Exposure& exposure, RunOutcome& outcome, std::vector<std::string>& warnings) {
  RunRecord& record = outcome.record;
  if (record.complete) return;
  const std::optional<Reference> some = reference_of(options, scene, search, record.light_paths);
  if (!some) {
    warnings.push_back(
        "no stored reference of the light paths that the method simulates, so its model error is unknown; make one: " +
        command_for(options, record.light_paths));
    return;
  }
  record.split =
      ErrorSplit{model_errors(all, *some, exposure),
                 errors_against(*some, outcome.surface, outcome.image, exposure, outcome.other_seeds), facts_of(scene, *some)};
}

/// The warning about missing effects gets the size of what is missing.
void tell_what_is_missing(RunRecord& record) {
  if (!record.split || record.plan.missing.empty()) return;
  const DomainErrors& total = record.split->model.at(Component::total);
  const auto seen = total.find(Domain::image);
  const auto size_of = [](const ErrorTable& errors) {
    const auto error = errors.find(headline_metric);
    return error == errors.end() ? std::string("an unknown share") : fmt::format("{:.2g}%", 100.0 * error->second.value);
  };
  std::string text = fmt::format("what is missing ({}) makes {} of the light at the surface samples (relative rmse)",
                                 names_of(record.plan.missing), size_of(total.at(Domain::surface)));
  if (seen != total.end()) text += fmt::format(", {} in the picture", size_of(seen->second));
  record.warnings.push_back(std::move(text));
}

void add_bounces(const RunOptions& options, const LoadedScene& scene, const ReferenceSearch& search, const MethodChoice& choice,
                 const CommonOptions& common, const Exposure& exposure, RunRecord& record, std::vector<std::string>& warnings) {
  if (!options.per_bounce) return;
  std::vector<std::string> lacking;
  const FindReference find = [&](const std::string& light_paths) {
    return reference_of(options, scene.scene(), search, light_paths);
  };
  record.per_bounce =
      errors_per_bounce(scene, choice, options.measuring, options.plan, common, *options.per_bounce, exposure, find, lacking);
  for (const std::string& light_paths : lacking)
    warnings.push_back("a bounce is left out, its reference is missing; make it: " + command_for(options, light_paths));
}

Exposure shown_exposure(const Scene& scene, const RunOutcome& outcome, const std::optional<Reference>& reference) {
  if (reference && reference->image.direct.size() > 0)
    return exposure_for(scene, Replicas::sum(reference->image.direct, reference->image.indirect).mean());
  return outcome.image ? exposure_for(scene, outcome.image->total()) : scene.exposure.value_or(Exposure{});
}

void print_errors(const std::string& what, const ComponentErrors& errors) {
  for (const auto& [component, domains] : errors)
    for (const auto& [domain, table] : domains)
      if (const auto error = table.find(headline_metric); error != table.end() && std::isfinite(error->second.value))
        fmt::print("  {:<8} light, {:<7}  {} {:.3f}% [{:.3f}, {:.3f}]{}\n", to_string(component), to_string(domain), what,
                   100.0 * error->second.value, 100.0 * error->second.low, 100.0 * error->second.high,
                   error->second.resolved ? "" : ", not resolved");
}

void print_summary(const RunRecord& record) {
  fmt::print("{} on {}\n", record.method, record.scene);
  fmt::print("  {:<14} {:.3f} s\n", "load", record.load_seconds);
  for (const auto& [stage, report] : record.stages)
    fmt::print("  {:<14} {:.3f} s, {}\n", to_string(stage), report.seconds, to_string(report.termination));
  print_errors("relative rmse", record.errors);
  if (record.split) {
    print_errors("model error", record.split->model);
    print_errors("discretisation error", record.split->discretisation);
  } else if (record.complete && !record.errors.empty()) {
    fmt::print("  every light path of the scene is simulated: no model error\n");
  }
  for (const BounceErrors& bounce : record.per_bounce) {
    fmt::print("bounce {}\n", bounce.bounce);
    const Component component = bounce.bounce == 0 ? Component::direct : Component::indirect;
    if (bounce.model) print_errors("model error", {{component, bounce.model->at(component)}});
    print_errors("discretisation error", {{component, bounce.discretisation.at(component)}});
  }
}

ExitStatus run(const RunOptions& options, const CommonOptions& common) {
  const MethodChoice choice = choose_method(options.method);
  strata_per_side(options.measuring.pixel_samples, "--pixel-samples");
  limits_of(options.plan, options.measuring.bounces);
  const LoadedScene scene = load_world(options.scene, common.threads);
  const std::optional<Camera> camera = chosen_camera(scene.scene(), options.measuring);
  std::optional<PictureLibrary> pictures;
  if (!options.out.empty() && camera) pictures.emplace();
  std::vector<std::string> warnings;
  require_memory(question_of(scene.scene(), options.measuring), available_memory(), options.method_seeds);
  using Stores = ReferenceSearch::Stores;
  const ReferenceSearch search(store_of(options), options.reference == "auto" ? Stores::own_then_shipped : Stores::own_only,
                               scene, common.threads, [&](const std::string& line) { warnings.push_back(line); });
  const std::optional<Reference> reference = stored_reference(options, scene.scene(), search, warnings);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, result_file, options.force);
  RunLog log(folder ? folder->partial() / log_file : std::filesystem::path(), common.quiet);

  RunOutcome outcome = run_method(scene, choice, options.measuring, options.plan, common, log);
  outcome.record.peak_bytes = pictures ? pictures->peak_bytes_without() : peak_bytes();
  if (reference) add_other_seeds(scene, choice, options.measuring, options.plan, common, options.method_seeds, log, outcome);
  const Exposure exposure = shown_exposure(scene.scene(), outcome, reference);
  if (outcome.image) outcome.record.exposure = exposure;
  if (reference) {
    outcome.record.errors = errors_against(*reference, outcome.surface, outcome.image, exposure, outcome.other_seeds);
    outcome.record.reference = facts_of(scene.scene(), *reference);
    outcome.pairs = pairs_against(*reference, outcome);
    split_errors(options, scene.scene(), search, *reference, exposure, outcome, warnings);
    tell_what_is_missing(outcome.record);
  }
  if (options.reference != "none") add_bounces(options, scene, search, choice, common, exposure, outcome.record, warnings);
  outcome.record.warnings.insert(outcome.record.warnings.end(), warnings.begin(), warnings.end());
  for (const std::string& warning : outcome.record.warnings) log.warn(warning);
  stop_if_cancelled();
  if (folder) {
    write_result_files(folder->partial(), outcome, exposure);
    stop_if_cancelled();
    folder->commit();
  }
  if (common.json) print_json(to_json(outcome.record));
  else if (!common.quiet) print_summary(outcome.record);
  return ExitStatus::done;
}

}  // namespace

void add_run(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "run", "Runs one method on one scene: its answers, their cost and their errors");
  verb->group(verb_group::computing);
  set_pages(*verb, {"docs/own-scene.md", "docs/files.md"});
  const auto options = std::make_shared<RunOptions>();
  add_scene_options(*verb, options->scene);
  add_method_options(*verb, options->method);
  add_measuring_options(*verb, options->measuring);
  add_plan_options(*verb, options->plan);
  add_light_paths_option(*verb, options->plan.light_paths);
  verb->add_option("--per-bounce", options->per_bounce,
                   "Also the errors of each bounce order from 0 to N separately; needs references of their light paths")
      ->check(CLI::Range(0, 64));
  verb->add_option(
          "--method-seeds", options->method_seeds,
          "Seeds, from --seed on, with which the method is run in all, so that its errors' intervals cover the choice of "
          "the seed; the first alone is timed")
      ->check(CLI::Range(1, most_method_seeds))
      ->capture_default_str();
  verb->add_option("--reference-seed", options->measuring.reference_seed,
                   "Seed of the reference, the surface samples and the camera rays")
      ->capture_default_str();
  verb->add_option("--reference", options->reference,
                   "auto: errors against a stored reference where there is one; none: no errors; or the folder of the store that "
                   "must have it")
      ->type_name("auto|none|FOLDER")
      ->capture_default_str();
  verb->add_option("--references", options->store, "Folder of the reference store for --reference auto")
      ->type_name(value_kind::folder)
      ->capture_default_str();
  verb->add_option(
          "--reference-state", options->reference_states,
          "A state of a stored reference (its key, and its paths for a value in all) in which it is taken; in another it is "
          "not; may be given again")
      ->type_name("KEY:PATHS")
      ->take_all();
  verb->add_option("--out", options->out,
                   "Folder for result.json, image.exr, previews and log.txt; without it nothing is written")
      ->type_name(value_kind::folder);
  verb->add_flag("--force", options->force, "Replace an older result in --out");
  verb->callback([&call, options] { call.action = [&call, options] { return run(*options, call.common); }; });
}

}  // namespace gibench
