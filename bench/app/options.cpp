#include "bench/app/options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>
#include <type_traits>

#include "bench/app/model_process.h"
#include "bench/app/value_kinds.h"
#include "bench/measure/measuring_fields.h"
#include "common/core/error.h"

namespace gibench {

namespace {

const OptionField<MeasuringOptions>& field_of(std::string_view option) {
  const auto fields = measuring_fields();
  const auto found = std::find_if(fields.begin(), fields.end(), [&](const auto& field) { return field.option == option; });
  GIBENCH_CHECK(found != fields.end(), "the table has this option");
  return *found;
}

template <class Options>
void add_field(CLI::App& verb, const OptionField<Options>& field, Options& options) {
  CLI::Option* option = std::visit(
      [&](auto member) -> CLI::Option* {
        using Value = std::remove_reference_t<decltype(options.*member)>;
        if constexpr (std::is_same_v<Value, bool>)
          return verb.add_flag_callback(
              field.option, [&options, member] { options.*member = false; }, field.meaning);
        else if constexpr (std::is_same_v<Value, std::string>)
          return verb.add_option(field.option, options.*member, field.meaning);
        else if constexpr (std::is_same_v<Value, std::size_t>)
          return verb.add_option(field.option, options.*member, field.meaning)->check(CLI::Range(field.least, field.most));
        else
          return verb.add_option(field.option, options.*member, field.meaning)
              ->check(CLI::Range(static_cast<int>(field.least), static_cast<int>(field.most)));
      },
      field.member);
  if (field.shows_default) option->capture_default_str();
}

}  // namespace

void add_scene_options(CLI::App& verb, SceneOptions& options) {
  verb.add_option("scene", options.name, "Scene file, model file or the name of a known scene")
      ->type_name(value_kind::scene)
      ->required();
  add_model_limits(verb, options.limits);
}

void add_model_limits(CLI::App& verb, ModelLimits& limits) {
  for (const auto& field : model_limit_fields()) add_field(verb, field, limits);
}

LoadedScene load_world(const SceneOptions& options, int threads) {
  return load_world(options.name, threads, reader_in_child(options.limits));
}

void add_method_options(CLI::App& verb, MethodOptions& options) {
  verb.add_option("--method", options.method, "Method; see gibench list methods")->type_name(value_kind::method)->required();
  verb.add_option("--preset", options.preset, "A named set of the method's parameters, which --set overrides; none: the defaults")
      ->type_name(value_kind::preset);
  verb.add_option("--set", options.settings, "A parameter of the method, name=value; may be given again")
      ->type_name(value_kind::setting)
      ->take_all();
}

MethodChoice choose_method(const MethodOptions& options) {
  return choose_method(options.method, options.settings, options.preset);
}

void add_measuring_options(CLI::App& verb, MeasuringOptions& options) {
  for (const auto& field : measuring_fields())
    if (*field.key != '\0') add_field(verb, field, options);
}

void add_relight_options(CLI::App& verb, RelightOptions& options) {
  for (const auto& field : relight_fields()) add_field(verb, field, options);
}

void add_bounces_option(CLI::App& verb, std::optional<int>& bounces) {
  const auto& field = field_of("--bounces");
  verb.add_option(field.option, bounces, field.meaning)
      ->check(CLI::Range(static_cast<int>(field.least), static_cast<int>(field.most)));
}

void add_plan_options(CLI::App& verb, PlanOptions& options) {
  verb.add_option("--effects", options.effects,
                  "Effects that may be simulated, separated by commas (see gibench list effects), or none; without it: all")
      ->type_name(value_kind::effects)
      ->take_last();
  verb.add_option("--tolerance", options.tolerance,
                  "Share of the light that bounces left out of the plan may hold; 0: none is left out")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

void add_light_paths_option(CLI::App& verb, std::string& light_paths) {
  const auto& field = field_of("--light-paths");
  verb.add_option(field.option, light_paths, field.meaning);
}

std::string command_line_of(const MeasuringOptions& options) {
  std::string line;
  for (const std::string& argument : arguments_of(options))
    line += argument == options.light_paths ? " '" + argument + "'" : " " + argument;
  const MeasuringOptions defaults;
  if (options.reference_seed != defaults.reference_seed) line += fmt::format(" --seed {}", options.reference_seed);
  return line;
}

}  // namespace gibench
