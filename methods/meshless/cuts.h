/// Walls that stand in the balls of fine basis functions.
#pragma once

#include "common/method/task.h"
#include "common/ray/world.h"
#include "methods/meshless/hierarchy.h"

namespace gibench::meshless {

/// Confines the functions of the last levels, the coarsest never among them, to their side of walls: where a short ray along the
/// surface meets another surface within the ball, the function ends at the plane of the nearest such and of the nearest that
/// faces elsewhere. What coarser functions carry through a wall finer levels put right, but none follows the last; and where the
/// two sides differ, a function that spans both may find nothing amiss at its own point and be left unrefined. Surfaces that face
/// about as the point does count as its own that bends.
void cut_at_walls(const World& world, Hierarchy& hierarchy, int last_levels, Task& task);

}  // namespace gibench::meshless
