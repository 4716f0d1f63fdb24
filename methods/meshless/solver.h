/// The radiosity solver: direct light in the basis where that is wanted, and the series of bounces (Lehtinen et al. 2007,
/// section 6.3).
#pragma once

#include <optional>
#include <string>

#include "common/lighting/direct_light.h"
#include "common/method/task.h"
#include "methods/meshless/expansion.h"
#include "methods/meshless/settings.h"
#include "methods/meshless/transport.h"

namespace gibench::meshless {

struct Solution {
  Termination termination = Termination::done;
  std::string message;
  std::optional<Expansion> indirect;  ///< Σ of the bounces, irradiance in W/m²; empty: none
  std::optional<Expansion> direct;    ///< only where direct light is answered from the basis
  std::size_t bytes() const { return (indirect ? indirect->bytes() : 0) + (direct ? direct->bytes() : 0); }
};

/// What of the solution is wanted.
struct Wanted {
  std::optional<int> max_bounces;  ///< reflections between a light and the surface asked about
  bool indirect = true;
  int channels = 3;  ///< 1: surfaces and lights are grey
};

/// Solves for the irradiance on the surfaces. At most wanted.max_bounces reflections where that is
/// given. Ends when the bounces left out hold less than settings.residual of the solution,
/// judged from the ratio of the last two; counts basis functions, gathers and evaluations in the task.
Solution solve(const World& world, const Transport& transport, const DirectLight& light, const Settings& settings,
               const Wanted& wanted, Task& task);

}  // namespace gibench::meshless
