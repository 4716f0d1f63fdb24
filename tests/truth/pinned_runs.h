/// The table runs.txt: how many questions of each case every rule's method answers.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace gibench::truth {

/// Cells of the table, by rule and by case: a number of questions, 0 where the method refuses the case or cannot do what it
/// calls for; empty where it is not asked, because other rules' answers stand for it.
using PinnedRuns = std::map<std::string, std::map<std::string, std::optional<int>>>;

const PinnedRuns& pinned_runs();

}  // namespace gibench::truth
