/// A piece of loose geometry as clusters and joins see it.
#pragma once

#include <cstdint>

#include "common/core/vec.h"

namespace gibench {

/// A point that stands for some area of a surface: of a triangle's side, a vertex's cell, a disc.
struct Place {
  Vec3 position;
  Vec3 normal;              ///< unit
  float area = 0.0F;        ///< m²
  std::uint32_t label = 0;  ///< places of different labels never come together
};

}  // namespace gibench
