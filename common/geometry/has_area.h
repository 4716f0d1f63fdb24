/// The test whether a scene has any surface at all to put points, vertices or elements on.
#pragma once

#include <algorithm>

#include "common/core/vec.h"
#include "common/scene/scene.h"

namespace gibench {

/// False for a scene without triangles and for one whose triangles are all degenerate.
inline bool has_area(const Scene& scene) {
  return std::any_of(scene.triangles.begin(), scene.triangles.end(), [&](const Triangle& triangle) {
    const auto& [a, b, c] = triangle.corners;
    const Vec3d first(scene.vertices[b] - scene.vertices[a]), second(scene.vertices[c] - scene.vertices[a]);
    return glm::length(glm::cross(first, second)) > 0.0;
  });
}

}  // namespace gibench
