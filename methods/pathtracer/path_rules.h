/// The rules which light paths count, and where walks may stop.
#pragma once

#include <cstdint>
#include <vector>

#include "common/light_paths/automaton.h"
#include "common/reflectance/bsdf.h"

namespace gibench::pathtracer {

/// The automaton of the paths that are meant, restricted to what the scene has, and what follows from it at every state.
class PathRules {
 public:
  using State = PathAutomaton::State;

  PathRules(const PathAutomaton& paths, bool tests_visibility);

  /// Not one path of the scene is meant.
  bool nothing() const { return !automaton_.alive(PathAutomaton::start); }
  bool tests_visibility() const { return tests_visibility_; }
  bool accepts(State state, PathEvent light) const { return automaton_.accepts(state, light); }
  /// Whether a vertex that is reached in this state is worth standing on.
  bool goes_on(State state) const { return automaton_.goes_on(state); }
  State after_diffuse(State state) const { return automaton_.next(state, PathEvent::diffuse_reflection); }
  State after_specular(State state, const SurfaceBsdf& bsdf) const {
    return automaton_.next(state, bsdf.is_delta() ? PathEvent::mirror_reflection : PathEvent::glossy_reflection);
  }

  /// The lobes by which a ray that leaves a vertex may still bring something.
  Lobes walking_lobes(State state, const SurfaceBsdf& bsdf) const {
    return pick(walkable_[after_diffuse(state)], walkable_[after_specular(state, bsdf)]);
  }
  /// The lobes whose light straight from such a light counts.
  Lobes lit_lobes(State state, const SurfaceBsdf& bsdf, PathEvent light) const {
    return pick(accepts(after_diffuse(state), light), accepts(after_specular(state, bsdf), light));
  }

 private:
  static Lobes pick(bool diffuse, bool specular) {
    return (diffuse ? Lobes::diffuse : Lobes::none) | (specular ? Lobes::specular : Lobes::none);
  }

  PathAutomaton automaton_;
  std::vector<std::uint8_t> walkable_;  ///< by state: a ray may meet a light that counts, or a vertex that goes on
  bool tests_visibility_;
};

}  // namespace gibench::pathtracer
