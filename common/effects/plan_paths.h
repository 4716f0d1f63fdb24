/// The light paths that a plan means, as an expression.
#pragma once

#include <optional>
#include <string>

#include "common/effects/effect_plan.h"

namespace gibench {

/// Reflections between a light and the surface asked about: what an answer is of.
struct BounceRange {
  int first = 0;
  std::optional<int> last;  ///< empty: no end
};

/// The paths that a plan means, as a light-path expression. `direct_of_every_lobe`: light straight from the lights is
/// computed with every lobe of the surface asked about, whatever else the method lacks. Bounds beyond 256 are not written.
std::string light_paths_of(const EffectPlan& plan, bool direct_of_every_lobe = false, const BounceRange& range = {});

}  // namespace gibench
