/// Vertices at one place, which formats without shared vertices repeat.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "common/core/vec.h"

namespace gibench {

/// For each position the index of the first that is equal in single precision, counted from the centre of them all as in
/// a scene.
std::vector<std::uint32_t> first_of_equal(std::span<const Vec3d> positions);

}  // namespace gibench
