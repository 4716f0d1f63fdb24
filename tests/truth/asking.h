/// Questions put to a method: point by point, or averaged over points of a surface.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/core/error.h"
#include "common/ray/world.h"
#include "methods/registry.h"
#include "truth_case.h"

namespace gibench::truth {

struct Answer {
  RgbDouble value;
  RgbDouble standard_error;  ///< zero from a method that does not know it, of a point
};

/// Both, for a message.
std::string tell(const Answer& answer, const Question& question);

/// How a method is run.
struct Run {
  std::vector<std::pair<std::string, std::string>> settings;
  std::uint64_t seed = 1;
  int mean_groups = 16;   ///< a mean is taken so many times, on independent points; its standard error is from their scatter
  int mean_points = 256;  ///< in each group
};

/// Why the method does not answer these questions, all of one emitter set and bounce bound; empty where it does.
std::optional<std::string> beyond(const MethodEntry& entry, const World& world, const std::vector<Question>& questions,
                                  const std::vector<std::pair<std::string, std::string>>& settings);

/// One answer for each question, all of one emitter set and bounce bound, in the world of the case. Throws
/// WorkError where a stage fails: the message says why.
std::vector<Answer> ask(const MethodEntry& entry, const World& world, const std::vector<Question>& questions, const Run& run);

}  // namespace gibench::truth
