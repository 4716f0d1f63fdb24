/// The options of a plan of effects: what a method may simulate, as the user asks for it.
#pragma once

#include <optional>
#include <string>

#include "common/effects/effect_plan.h"

namespace gibench {

/// As given on the command line or in a study.
struct PlanOptions {
  std::string effects;      ///< names separated by commas; "none"; empty: all
  double tolerance = 0.0;   ///< share of the light that bounces left out may hold; 0: none is left out
  std::string light_paths;  ///< an expression; empty: all paths

  bool operator==(const PlanOptions&) const = default;
};

/// Throws InputError for an unknown effect, the known ones listed, and for a malformed expression.
PlanLimits limits_of(const PlanOptions& options, std::optional<int> bounces);

}  // namespace gibench
