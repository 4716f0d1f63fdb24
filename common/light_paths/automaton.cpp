#include "common/light_paths/automaton.h"

#include <fmt/format.h>

#include <limits>
#include <map>
#include <set>
#include <utility>

#include "common/core/error.h"
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
  const NondeterministicPaths paths(expression);
  Numbering<NondeterministicPaths::Set> number;
  std::vector<NondeterministicPaths::Set> sets{paths.step(paths.start(), PathEvent::camera)};
  number(sets.front());
  for (std::size_t i = 0; i < sets.size(); ++i) {
    Step step;
    for (std::size_t e = 0; e < scattering_events.size(); ++e) {
      NondeterministicPaths::Set set = paths.step(sets[i], scattering_events[e]);
      const auto [to, is_new] = number(set);
      if (to >= most_states)
        throw InputError(fmt::format("light paths '{}'", expression.text), fmt::format("needs more than {} states", most_states),
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

/// Moore's partition refinement; the classes are then numbered in the order in which they are reached.
void PathAutomaton::minimise() {
  std::vector<std::size_t> group(states_.size(), 0);
  for (std::size_t groups = 0;;) {
    Numbering<std::vector<std::size_t>> number;
    std::vector<std::size_t> finer;
    std::size_t count = 0;
    for (std::size_t s = 0; s < states_.size(); ++s) {
      std::vector<std::size_t> signature{group[s]};
      for (const State to : states_[s].next) signature.push_back(group[to]);
      for (const PathEvent light : ending_events) signature.push_back(states_[s].accepted.contains(light) ? 1 : 0);
      const auto [place, is_new] = number(signature);
      finer.push_back(place);
      count += is_new ? 1 : 0;
    }
    group = std::move(finer);
    if (count == groups) break;
    groups = count;
  }
  // States are visited in the order in which paths reach them, so groups are, too; the start's is the first.
  std::vector<Step> merged;
  Numbering<std::size_t> number;
  std::vector<std::size_t> member{0};
  number(group[0]);
  for (std::size_t i = 0; i < member.size(); ++i) {
    Step step = states_[member[i]];
    for (State& to : step.next) {
      const auto [place, is_new] = number(group[to]);
      if (is_new) member.push_back(to);
      to = static_cast<State>(place);
    }
    merged.push_back(step);
  }
  states_ = std::move(merged);
  find_the_living();
}

void PathAutomaton::find_the_living() {
  for (Step& step : states_) step.alive = !step.accepted.empty(), step.goes_on = false;
  for (bool changed = true; changed;) {
    changed = false;
    for (auto step = states_.rbegin(); step != states_.rend(); ++step)
      for (const State to : step->next)
        if (states_[to].alive && !step->goes_on) step->alive = step->goes_on = changed = true;
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

bool equivalent(const PathAutomaton& a, const PathAutomaton& b) {
  using Pair = std::pair<PathAutomaton::State, PathAutomaton::State>;
  std::set<Pair> seen{{PathAutomaton::start, PathAutomaton::start}};
  std::vector<Pair> open(seen.begin(), seen.end());
  while (!open.empty()) {
    const auto [in_a, in_b] = open.back();
    open.pop_back();
    if (a.states_[in_a].accepted != b.states_[in_b].accepted) return false;
    for (const PathEvent event : scattering_events)
      if (const Pair pair{a.next(in_a, event), b.next(in_b, event)}; seen.insert(pair).second) open.push_back(pair);
  }
  return true;
}

}  // namespace gibench
