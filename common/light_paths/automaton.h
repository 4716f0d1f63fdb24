/// A light-path expression compiled to a small deterministic automaton, which a path tracer steps at every vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "common/light_paths/expression.h"
#include "common/light_paths/path_event.h"

namespace gibench {

/// Minimal: two states that accept the same continuations are one, and all states from which nothing is accepted are one
/// dead state. Paths have one camera event first, scattering events, and one light at the end: an expression's other
/// strings count for nothing.
class PathAutomaton {
 public:
  using State = std::uint16_t;
  /// Of a path that has left the camera.
  static constexpr State start = 0;

  /// All paths: C.*[LOB].
  PathAutomaton();
  /// Throws InputError for an expression whose counts make more states than 16 bits number.
  explicit PathAutomaton(const PathExpression& expression);
  explicit PathAutomaton(const std::string& expression) : PathAutomaton(parse_light_paths(expression)) {}

  /// After one more scattering.
  State next(State state, PathEvent scattering) const { return states_[state].next[static_cast<unsigned>(scattering) - 1U]; }
  /// Whether a path that ends here at this light is meant.
  bool accepts(State state, PathEvent light) const { return states_[state].accepted.contains(light); }
  /// Whether a path that is here can still be one that is meant.
  bool alive(State state) const { return states_[state].alive; }
  /// Whether it can be after one more scattering at least.
  bool goes_on(State state) const { return states_[state].goes_on; }
  /// Whether diffuse, glossy and mirror reflection lead to the same state from every state.
  bool tells_reflections_apart() const { return tells_reflections_apart_; }
  std::size_t size() const { return states_.size(); }

  /// camera, scattering …, light.
  bool matches(std::span<const PathEvent> path) const;

  /// The same for paths of these events alone: what a scene without the others asks for.
  PathAutomaton restricted_to(PathEvents available) const;

  friend bool equivalent(const PathAutomaton& a, const PathAutomaton& b);

 private:
  struct Step {
    std::array<State, 6> next{};  ///< by scattering event
    PathEvents accepted;          ///< lights
    bool alive = false, goes_on = false;
  };
  explicit PathAutomaton(std::vector<Step> states);
  void minimise();
  void find_the_living();

  std::vector<Step> states_;
  bool tells_reflections_apart_ = false;
};

/// Whether both mean the same paths.
bool equivalent(const PathAutomaton& a, const PathAutomaton& b);

}  // namespace gibench
