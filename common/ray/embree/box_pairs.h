/// Pairs of boxes that overlap, found by Embree's hierarchies.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "common/core/vec.h"

namespace gibench {

/// A box along the axes, both ends included.
struct Box {
  Vec3 low{0.0F}, high{0.0F};
};

using IndexPair = std::array<std::uint32_t, 2>;

/// All (i, j), i < j, in ascending order, whose boxes overlap or touch and which `keep` accepts; `keep` is called from
/// several threads, perhaps twice for a pair. `threads` 0: all cores. Throws WorkError.
std::vector<IndexPair> overlapping_boxes(std::span<const Box> boxes, int threads,
                                         const std::function<bool(std::uint32_t, std::uint32_t)>& keep);

}  // namespace gibench
