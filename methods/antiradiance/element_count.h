/// The number of elements that a scene needs.
#pragma once

#include <cstddef>

#include "common/geometry/sampling_mesh.h"

namespace gibench::antiradiance {

/// What does for a plain room.
inline constexpr int elements_of_a_room = 4096;

/// Vertices of a mesh at which its surface has a corner or bends; not those inside a plane or a straight edge, of which finer
/// faces make more without making more shape.
std::size_t corner_count(const SamplingMesh& mesh);

/// Those of a room, or of a scene with more corners than that the geometric mean of the two: detail wants smaller elements, but
/// it stands in groups that one element can do for.
int elements_for(std::size_t corners);

}  // namespace gibench::antiradiance
