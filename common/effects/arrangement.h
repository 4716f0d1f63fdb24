/// The arrangement of surfaces, as far as visibility depends on it.
#pragma once

#include "common/ray/world.h"

namespace gibench {

/// Whether surfaces can hide one another, and if not, why.
enum class Arrangement {
  general,          ///< surfaces may hide one another
  convex_room,      ///< every front looks into one convex space: all fronts see one another
  no_mutual_sight,  ///< every surface lies behind (or in the plane of) every other: a convex body, a flat plate
};
/// Exact up to 1e-5 of the scene's diagonal; degenerate triangles do not count. `general` for more than 4096 triangles,
/// where looking at every pair would cost more than it saves.
Arrangement arrangement_of(const World& world);

/// Whether something may lie between a light and a lit side that faces it: exact or true. The surfaces' own emission is
/// never hidden in a convex room, nor a punctual light inside it; nothing is from a body that no surface sees. `sealed`:
/// what lies outside at infinity gives nothing and so is not hidden.
bool lights_may_be_hidden(const World& world, Arrangement arrangement, bool sealed, const Lighting& lighting);

}  // namespace gibench
