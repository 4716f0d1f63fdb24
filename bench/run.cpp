#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>
#include <nlohmann/json.hpp>

#include "bench/cancellation.h"
#include "bench/measuring_options.h"
#include "bench/output_folder.h"
#include "bench/print_json.h"
#include "bench/result_files.h"
#include "bench/run_errors.h"
#include "bench/run_method.h"
#include "bench/verbs.h"
#include "common/core/error.h"

namespace gibench {

namespace {

struct RunOptions {
  std::string scene, method;
  std::vector<std::string> settings;
  MeasuringOptions measuring;
  std::string reference = "auto", store = "references";
  std::filesystem::path out;
  bool force = false;
};

/// The stored reference, or none with a warning that names the command that makes it. Never makes one.
std::optional<Reference> stored_reference(const RunOptions& options, const Scene& scene, std::vector<std::string>& warnings) {
  if (options.reference == "none") return std::nullopt;
  const bool named = options.reference != "auto";
  const std::string folder = named ? options.reference : options.store;
  auto found = ReferenceStore(folder).find(scene, question_of(scene, options.measuring));
  const std::string command =
      fmt::format("gibench reference {} --references {}{}", options.scene, folder, command_line_of(options.measuring));
  if (!found && named)
    throw InputError("--reference " + folder, "holds no reference of this scene and question", "make it: " + command);
  if (!found) warnings.push_back("no stored reference, so no errors; make one: " + command);
  return found;
}

Exposure shown_exposure(const Scene& scene, const RunOutcome& outcome, const std::optional<Reference>& reference) {
  if (reference && reference->image.direct.size() > 0)
    return exposure_for(scene, Replicas::sum(reference->image.direct, reference->image.indirect).mean());
  return outcome.image ? exposure_for(scene, outcome.image->total()) : scene.exposure.value_or(Exposure{});
}

void print_summary(const RunRecord& record) {
  fmt::print("{} on {}\n", record.method, record.scene);
  fmt::print("  {:<14} {:.3f} s\n", "load", record.load_seconds);
  for (const auto& [stage, report] : record.stages)
    fmt::print("  {:<14} {:.3f} s, {}\n", stage, report.seconds, to_string(report.termination));
  for (const auto& [component, domains] : record.errors)
    for (const auto& [domain, table] : domains)
      if (const auto error = table.find("relative_rmse"); error != table.end() && std::isfinite(error->second.value))
        fmt::print("  {:<8} light, {:<7}  relative rmse {:.3f}% [{:.3f}, {:.3f}]{}\n", component, domain,
                   100.0 * error->second.value, 100.0 * error->second.low, 100.0 * error->second.high,
                   error->second.below_noise_floor ? ", below the noise floor" : "");
}

ExitStatus run(const RunOptions& options, const CommonOptions& common) {
  const MethodChoice choice = choose_method(options.method, options.settings);
  strata_per_side(options.measuring.pixel_samples, "--pixel-samples");
  const LoadedScene scene = load_world(options.scene, common.threads);
  chosen_camera(scene.scene(), options.measuring);
  std::vector<std::string> warnings;
  const std::optional<Reference> reference = stored_reference(options, scene.scene(), warnings);
  std::optional<OutputFolder> folder;
  if (!options.out.empty()) folder.emplace(options.out, result_file, options.force);
  RunLog log(folder ? folder->partial() / log_file : std::filesystem::path(), common.quiet);

  RunOutcome outcome = run_method(scene, choice, options.measuring, common, log);
  const Exposure exposure = shown_exposure(scene.scene(), outcome, reference);
  if (outcome.image) outcome.record.exposure = exposure;
  if (reference) {
    outcome.record.errors = errors_against(*reference, outcome, exposure);
    outcome.record.reference = facts_of(scene.scene(), *reference);
  }
  outcome.record.warnings.insert(outcome.record.warnings.end(), warnings.begin(), warnings.end());
  for (const std::string& warning : outcome.record.warnings) log.warn(warning);
  stop_if_cancelled();
  const nlohmann::ordered_json json = to_json(outcome.record);
  if (folder) {
    write_result_files(folder->partial(), outcome, exposure, json);
    stop_if_cancelled();
    folder->commit();
  }
  if (common.json) print_json(json);
  else if (!common.quiet) print_summary(outcome.record);
  return ExitStatus::done;
}

}  // namespace

void add_run(CLI::App& app, Call& call) {
  CLI::App* verb = add_verb(app, call, "run", "One method on one scene: its answers, their cost and their errors");
  const auto options = std::make_shared<RunOptions>();
  verb->add_option("scene", options->scene, "Scene file, model file or the name of a known scene")->required();
  verb->add_option("--method", options->method, "Method; see gibench list methods")->required();
  verb->add_option("--set", options->settings, "A parameter of the method, name=value; may be given again")->take_all();
  add_measuring_options(*verb, options->measuring);
  verb->add_option("--reference-seed", options->measuring.reference_seed,
                   "Seed of the reference, the surface samples and the camera rays")
      ->capture_default_str();
  verb->add_option("--reference", options->reference,
                   "auto: errors against a stored reference where there is one; none: no errors; or the folder of the store that "
                   "must have it")
      ->capture_default_str();
  verb->add_option("--references", options->store, "Folder of the reference store for --reference auto")->capture_default_str();
  verb->add_option("--out", options->out,
                   "Folder for result.json, image.exr, previews and log.txt; without it nothing is written");
  verb->add_flag("--force", options->force, "Replace an older result in --out");
  verb->callback([&call, options] { call.action = [&call, options] { return run(*options, call.common); }; });
}

}  // namespace gibench
