/// The steps of a SideLight: straight light, rays from side to side, rounds of reflections, what cameras see.
#pragma once

#include <cstdint>
#include <vector>

#include "common/method/task.h"
#include "common/ray/world.h"
#include "common/spaces/side_cells.h"

namespace gibench {

/// One value or flag for every cell.
struct CellLight {
  std::vector<float> irradiance;   ///< W/m², straight light and reflections
  std::vector<float> brightest;    ///< the same; of a divided cell (CellPoints) that of its brightest point
  std::vector<std::uint8_t> seen;  ///< 1: by a camera, or by one diffuse reflection
};

CellLight light_of_cells(const World& world, const SideCells& cells, Task& task);

/// A side that light can leave: a front, or the back of a two-sided object.
bool can_reflect(const World& world, std::uint32_t triangle, bool front);

}  // namespace gibench
