/// The states of a deterministic automaton that accept the same continuations.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "common/light_paths/path_event.h"

namespace gibench {

/// For each state, those that follow by event.
using Followers = std::vector<std::array<std::uint16_t, scattering_events.size()>>;

/// Parts of equal states, by number, of states that `kind` tells apart at once. Hopcroft (1971), "An n log n algorithm for
/// minimizing states in a finite automaton": a part is refined by those that lead into the smaller half of one that was split.
std::vector<std::uint32_t> parts_of_equal_states(const Followers& next, const std::vector<std::uint32_t>& kind);

}  // namespace gibench
