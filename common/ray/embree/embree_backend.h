/// The ray backend on Embree, which only the files of this folder include.
#pragma once

#include <memory>
#include <span>

#include "common/ray/ray_backend.h"

namespace gibench {

/// A bounding volume hierarchy in robust mode; batches are traced in packets, in the order given. As MakeRayBackend asks.
std::unique_ptr<const RayBackend> make_embree_backend(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                                      int threads);

}  // namespace gibench
