#include "bench/measure/plan_options.h"

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
