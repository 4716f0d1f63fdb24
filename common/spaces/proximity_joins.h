/// Joins of small pieces of loose geometry to what lies beside them and faces the same way.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "common/method/task.h"
#include "common/spaces/place.h"

namespace gibench {

/// Two places of different pieces, by index, that are to be connected.
struct Join {
  std::uint32_t from, to;
};

/// Joins until at most `pieces_wanted` pieces remain, or nothing is left to join. A piece asks for the nearest place of another
/// piece with the same label, first within `first_distance` metres and an angle whose cosine is 0.8, then 0.3, then within twice
/// that distance, up to 256 times, at last at any angle below a right one; of those that find one, the smallest by area are
/// joined first. Pieces with more than their share (1 / `pieces_wanted`) of the area do not ask. `piece`: of every place, any
/// numbers. O(n log n) for each of these rounds; visits are counted as `join_visits`, joins as `piece_joins`.
std::vector<Join> join_small_pieces(std::span<const Place> places, std::span<const std::uint32_t> piece,
                                    std::size_t pieces_wanted, float first_distance, Task& task);

}  // namespace gibench
