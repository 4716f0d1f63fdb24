/// The part of meshless radiosity that the geometry alone decides: groups and basis points.
#pragma once

#include "methods/meshless/groups.h"
#include "methods/meshless/hierarchy.h"

namespace gibench::meshless {

/// Made by prepare(), used by every light().
struct Transport {
  Groups groups;
  Hierarchy hierarchy;
};

/// The levels that bounces are solved on: as many as the settings say, fewer where their points are too many to be linked all to
/// all. None where every bounce is gathered over all levels.
std::uint32_t coarse_levels(const Hierarchy& hierarchy, const Settings& settings);

}  // namespace gibench::meshless
