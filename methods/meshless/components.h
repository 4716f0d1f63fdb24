/// Connected components of a scene's triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "common/ray/world.h"

namespace gibench::meshless {

/// A number for every triangle, the same for those of one component. Triangles are connected where corners coincide, and where a
/// corner lies on an edge that belongs to no other triangle, both of one Object::group: polygons that abut with T-junctions are
/// one surface.
std::vector<std::uint32_t> connected_components(const World& world);

/// A number for every object, the same for those of one Object::group.
std::vector<std::uint32_t> group_numbers(const Scene& scene);

}  // namespace gibench::meshless
