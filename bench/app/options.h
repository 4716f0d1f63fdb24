/// The command-line options that several verbs share: where methods are asked, and what they may simulate.
#pragma once

#include "bench/measure/loaded_scene.h"
#include "bench/measure/measuring.h"
#include "bench/measure/model_limits.h"
#include "bench/measure/plan_options.h"
#include "bench/measure/relight_options.h"
#include "bench/measure/run_method.h"

namespace CLI {
class App;
}

namespace gibench {

/// The scene, which every verb that has one names first, and the limits of a model that is one: --model-seconds, --model-memory
struct SceneOptions {
  std::string name;
  ModelLimits limits;
};
void add_scene_options(CLI::App& verb, SceneOptions& options);
void add_model_limits(CLI::App& verb, ModelLimits& limits);
/// As load_world() does; a bare model of a format that gibench does not read itself in a process of its own.
LoadedScene load_world(const SceneOptions& options, int threads);
/// --method, --preset and --set
struct MethodOptions {
  std::string method, preset;
  std::vector<std::string> settings;
};
void add_method_options(CLI::App& verb, MethodOptions& options);
MethodChoice choose_method(const MethodOptions& options);
/// --surface-samples, --pixel-samples, --camera, --width, --no-pictures, --bounces
void add_measuring_options(CLI::App& verb, MeasuringOptions& options);
/// --frames, --surface-samples, --compared-samples, --reference-samples
void add_relight_options(CLI::App& verb, RelightOptions& options);
/// --bounces alone
void add_bounces_option(CLI::App& verb, std::optional<int>& bounces);
/// --effects and --tolerance
void add_plan_options(CLI::App& verb, PlanOptions& options);
/// --light-paths
void add_light_paths_option(CLI::App& verb, std::string& light_paths);

/// The options as they would be written after `gibench reference SCENE`, those at their defaults left out.
std::string command_line_of(const MeasuringOptions& options);

}  // namespace gibench
