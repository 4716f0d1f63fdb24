/// Pairs of triangles that lie in one plane and overlap there: faces modelled twice, both sides of a sheet, a rug in the
/// floor's plane.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

/// a < b.
struct CoplanarPair {
  std::uint32_t a, b;
  bool same_winding;  ///< their fronts look the same way
  bool same_corners;  ///< the corners lie at the same three places, in any order; otherwise they overlap in part
};

/// All pairs in ascending order, closer to each other than rays can tell apart (World::offset()). Triangles that touch along
/// an edge and degenerate ones are no pairs. `threads` 0: all cores.
std::vector<CoplanarPair> coplanar_pairs(std::span<const Vec3> vertices, std::span<const Triangle> triangles, int threads);

}  // namespace gibench
