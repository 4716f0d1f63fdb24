/// The comparison of every two runs of a scene, by the terms of their errors.
#pragma once

#include <cstddef>
#include <functional>

#include "reports/collect/study.h"

namespace gibench::report {

/// Of each error those runs are compared whose errors are smallest, as they are shown: so many at most.
inline constexpr std::size_t most_compared_runs = 20;

/// Fills in the scenes' comparisons. Terms that cannot be read are left out, with a line in the study's warnings. `may_go_on` is
/// asked before each file and stops the work by throwing.
void compare_runs(Study& study, const std::function<void()>& may_go_on);

}  // namespace gibench::report
