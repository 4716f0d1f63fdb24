/// A point of an element's cell: where rays of the element begin.
#pragma once

#include <cstdint>

#include "common/core/vec.h"
#include "common/ray/world.h"

namespace gibench::antiradiance {

/// A point of a cell, for rays: of all points of an element equal shares of its area.
struct CellPoint {
  Vec3 origin;  ///< metres, off the surface on the element's side
  Vec3 behind;  ///< the same off its other side
  Vec3 normal;  ///< of the face, on the element's side
  std::uint32_t triangle = 0;
  bool exposed = true;  ///< seen by some light: see Elements
};

/// A point of a cell as a sample; a part of a quad names the first of its two triangles.
SurfaceSample sample_of(const World& world, const CellPoint& point);

}  // namespace gibench::antiradiance
