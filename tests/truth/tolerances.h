/// The test of a method that does not know its errors.
#pragma once

#include <vector>

#include "method_rules.h"
#include "truth_case.h"

namespace gibench::truth {

/// Expects every answer within the bounds that bounds.json has for the rule. With GIBENCH_TRUTH_SEEDS=N in the environment the
/// questions are asked with the seeds 1 to N, and each miss is printed: what the file's bounds are measured by.
void hold_to_bounds(const MethodRule& rule, const TruthCase& truth, const std::vector<std::vector<Question>>& groups);

}  // namespace gibench::truth
