/// The test of a method that knows its own standard errors.
#pragma once

#include <vector>

#include "method_rules.h"
#include "truth_case.h"

namespace gibench::truth {

/// Expects every answer within four standard errors of the truth, and the scores of all to scatter as chance has it.
void hold_to_standard_errors(const MethodRule& rule, const TruthCase& truth, const std::vector<std::vector<Question>>& groups);

}  // namespace gibench::truth
