#include "bench/measure/plan_options.h"

#include <CLI/CLI.hpp>
#include <sstream>

#include "common/light_paths/automaton.h"

namespace gibench {

namespace {

std::vector<std::string> names_in(const std::string& text) {
  std::vector<std::string> names;
  std::istringstream parts(text);
  for (std::string name; std::getline(parts, name, ',');) {
    const std::size_t begin = name.find_first_not_of(' '), end = name.find_last_not_of(' ');
    names.push_back(begin == std::string::npos ? std::string() : name.substr(begin, end - begin + 1));
  }
  return names;
}

}  // namespace

void add_plan_options(CLI::App& verb, PlanOptions& options) {
  verb.add_option("--effects", options.effects,
                  "Effects that may be simulated, commas between; see gibench list effects. none: nothing; without it: all")
      ->take_last();
  verb.add_option("--tolerance", options.tolerance,
                  "Share of the light that bounces left out of the plan may hold; 0: none is left out")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
}

void add_light_paths_option(CLI::App& verb, std::string& light_paths) {
  verb.add_option("--light-paths", light_paths,
                  "Only these paths, an expression such as C.{0,1}[LOB]|CDD+[LOB]; without it: all");
}

PlanLimits limits_of(const PlanOptions& options, std::optional<int> bounces) {
  PlanLimits limits;
  limits.bounces = bounces;
  limits.tolerance = options.tolerance;
  if (options.effects == "none") limits.allowed = EffectSet();
  else if (!options.effects.empty()) limits.allowed = effects_of_names(names_in(options.effects), "--effects");
  if (!options.light_paths.empty()) PathAutomaton{options.light_paths};
  return limits;
}

}  // namespace gibench
