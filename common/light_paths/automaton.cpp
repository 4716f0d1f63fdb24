#include "common/light_paths/automaton.h"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <optional>
#include <utility>

#include "common/core/error.h"
#include "common/light_paths/equal_states.h"
#include "common/light_paths/nondeterministic.h"

namespace gibench {

namespace {

constexpr std::size_t most_states = std::numeric_limits<PathAutomaton::State>::max();

/// Numbers for keys in the order in which they come.
template <class Key>
class Numbering {
 public:
  /// The number, and whether it is new.
  std::pair<std::size_t, bool> operator()(const Key& key) {
    const auto [place, is_new] = numbers_.try_emplace(key, numbers_.size());
    return {place->second, is_new};
  }

 private:
  std::map<Key, std::size_t> numbers_;
};

}  // namespace

PathAutomaton::PathAutomaton() : PathAutomaton(std::string("C.*[LOB]")) {}

/// The subset construction, from after the camera.
PathAutomaton::PathAutomaton(const PathExpression& expression) {
  NondeterministicPaths paths(expression);
  Numbering<NondeterministicPaths::Set> number;
  std::vector<NondeterministicPaths::Set> sets{paths.step(paths.start(), PathEvent::camera)};
  number(sets.front());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    Step step;
    for (std::size_t e = 0; e < scattering_events.size(); ++e) {
      NondeterministicPaths::Set set = paths.step(sets[i], scattering_events[e]);
      const auto [to, is_new] = number(set);
      if (to >= most_states)
        throw InputError(place_of_light_paths(expression.text), fmt::format("needs more than {} states", most_states),
                         "lower its counts, or write * for no bound");
      step.next[e] = static_cast<State>(to);
      if (is_new) sets.push_back(std::move(set));
    }
    for (const PathEvent light : ending_events)
      if (paths.accepts(paths.step(sets[i], light))) step.accepted |= light;
    states_.push_back(step);
  }
  minimise();
}

PathAutomaton::PathAutomaton(std::vector<Step> states) : states_(std::move(states)) { minimise(); }

/// The parts of equal states are numbered in the order in which they are reached.
void PathAutomaton::minimise() {
  Followers next;
  std::vector<std::uint32_t> kind;
  for (const Step& step : states_) {
    next.push_back(step.next);
    std::uint32_t bits = 0;
    for (const PathEvent light : ending_events) bits = 2 * bits + (step.accepted.contains(light) ? 1U : 0U);
    kind.push_back(bits);
  }
  const std::vector<std::uint32_t> part = parts_of_equal_states(next, kind);
  std::vector<Step> merged;
  Numbering<std::uint32_t> number;
  std::vector<std::size_t> member{0};
  number(part[0]);
  for (std::size_t i = 0; i < member.size(); ++i) {
    Step step = states_[member[i]];
    for (State& to : step.next) {
      const auto [place, is_new] = number(part[to]);
      if (is_new) member.push_back(to);
      to = static_cast<State>(place);
    }
    merged.push_back(step);
  }
  states_ = std::move(merged);
  find_the_living();
}

/// From those that accept a light backwards, along every edge once.
void PathAutomaton::find_the_living() {
  std::vector<std::vector<State>> before(states_.size());
  std::vector<State> living;
  for (std::size_t s = 0; s < states_.size(); ++s) {
    Step& step = states_[s];
    for (const State to : step.next) before[to].push_back(static_cast<State>(s));
    step.alive = !step.accepted.empty(), step.goes_on = false;
    if (step.alive) living.push_back(static_cast<State>(s));
  }
  while (!living.empty()) {
    const State to = living.back();
    living.pop_back();
    for (const State from : before[to]) {
      states_[from].goes_on = true;
      if (!states_[from].alive) states_[from].alive = true, living.push_back(from);
    }
  }
  tells_reflections_apart_ = false;
  for (const Step& step : states_)
    tells_reflections_apart_ = tells_reflections_apart_ || step.next[0] != step.next[1] || step.next[0] != step.next[2];
}

bool PathAutomaton::matches(std::span<const PathEvent> path) const {
  if (path.size() < 2 || path.front() != PathEvent::camera || !light_ends.contains(path.back())) return false;
  State state = start;
  for (const PathEvent event : path.subspan(1, path.size() - 2)) {
    if (event == PathEvent::camera || light_ends.contains(event)) return false;
    state = next(state, event);
  }
  return accepts(state, path.back());
}

PathAutomaton PathAutomaton::restricted_to(PathEvents available) const {
  std::vector<Step> states = states_;
  const auto dead = static_cast<State>(states.size());
  for (Step& step : states) {
    step.accepted = step.accepted & available;
    for (std::size_t e = 0; e < scattering_events.size(); ++e)
      if (!available.contains(scattering_events[e])) step.next[e] = dead;
  }
  Step nowhere;
  nowhere.next.fill(dead);
  states.push_back(nowhere);
  return PathAutomaton(std::move(states));
}

/// Both are minimal: equal states are then one in each, and a second partner for a state is a difference.
bool equivalent(const PathAutomaton& a, const PathAutomaton& b) {
  if (a.size() != b.size()) return false;
  std::vector<std::optional<PathAutomaton::State>> partner(a.size());
  partner[PathAutomaton::start] = PathAutomaton::start;
  std::vector<PathAutomaton::State> open{PathAutomaton::start};
  while (!open.empty()) {
    const PathAutomaton::State in_a = open.back(), in_b = *partner[in_a];
    open.pop_back();
    if (a.states_[in_a].accepted != b.states_[in_b].accepted) return false;
    for (const PathEvent event : scattering_events) {
      auto& known = partner[a.next(in_a, event)];
      const PathAutomaton::State found = b.next(in_b, event);
      if (known && *known != found) return false;
      if (!known) known = found, open.push_back(a.next(in_a, event));
    }
  }
  return true;
}

}  // namespace gibench
