#include "methods/pathtracer/path_rules.h"

namespace gibench::pathtracer {

PathRules::PathRules(const PathAutomaton& paths, bool tests_visibility) : automaton_(paths), tests_visibility_(tests_visibility) {
  for (std::size_t i = 0; i < automaton_.size(); ++i) {
    const auto state = static_cast<State>(i);
    const bool meets_light = accepts(state, PathEvent::emitter) || accepts(state, PathEvent::background);
    walkable_.push_back(meets_light || automaton_.goes_on(state) ? 1 : 0);
  }
}

}  // namespace gibench::pathtracer
