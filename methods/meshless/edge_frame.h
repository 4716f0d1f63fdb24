/// A frame that turns with the scene.
#pragma once

#include "common/core/vec.h"
#include "common/ray/world.h"

namespace gibench::meshless {

/// Its tangent lies along the triangle's first edge.
inline Frame frame_along_edge(const World& world, std::uint32_t triangle, const Vec3& normal) {
  Frame frame(normal);
  const auto& corners = world.scene().triangles[triangle].corners;
  const Vec3 edge = world.scene().vertices[corners[1]] - world.scene().vertices[corners[0]];
  const Vec3 across = glm::cross(normal, edge);
  const float length = glm::length(across);
  if (!(length > 0.0F)) return frame;
  frame.bitangent = across / length;
  frame.tangent = glm::cross(frame.bitangent, normal);
  return frame;
}

}  // namespace gibench::meshless
