/// A method's answers with further seeds, by which errors cover the choice of the seed.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "bench/measure/measuring.h"

namespace gibench {

/// What a method answered with one seed.
struct SeedAnswers {
  std::uint64_t seed = 1;
  Answers surface;
  std::optional<Answers> image;
};

/// Of the option --method-seeds: how often a method may be run.
inline constexpr int most_method_seeds = 64;

}  // namespace gibench
