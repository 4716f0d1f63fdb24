#include "common/effects/arrangement.h"

#include <algorithm>
#include <vector>

#include "common/geometry/convexity.h"
#include "common/geometry/mesh_topology.h"
#include "common/scene/light_kinds.h"

namespace gibench {

namespace {

// Triangles; every one is tested against every vertex, so larger meshes are taken as general: never wrong, at most not the
// least work.
constexpr std::size_t largest_arrangement = 4096;
constexpr float planarity = 1e-5F;     // of the scene's diagonal
constexpr float light_margin = 1e-6F;  // of the diagonal, by which a light in a wall may lie behind it

/// Metres above the plane of a triangle, on its front; 0 for a degenerate one.
float height_above(const World& world, std::uint32_t triangle, const Vec3& point) {
  return glm::dot(world.normal(triangle), point - world.scene().vertices[world.scene().triangles[triangle].corners[0]]);
}

std::vector<std::uint32_t> corners_of(const Scene& scene) {
  std::vector<std::uint32_t> corners;
  for (const Triangle& triangle : scene.triangles)
    corners.insert(corners.end(), triangle.corners.begin(), triangle.corners.end());
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  return corners;
}

bool is_inside(const World& world, const Vec3& position) {
  const float margin = light_margin * world.diagonal();
  for (std::uint32_t t = 0; t < world.scene().triangles.size(); ++t)
    if (height_above(world, t, position) < -margin) return false;
  return true;
}

}  // namespace

Arrangement arrangement_of(const World& world) {
  const Scene& scene = world.scene();
  if (scene.triangles.size() > largest_arrangement) return Arrangement::general;
  const float tolerance = planarity * world.diagonal();
  const std::vector<std::uint32_t> weld = weld_vertices(scene.vertices, weld_tolerance(scene.vertices));
  if (!bounds_convex_set(scene.vertices, scene.triangles, weld, tolerance)) return Arrangement::general;
  // All vertices lie on one side of every face: on its front, or behind it, or (a flat plate) in its plane.
  float highest = 0.0F, lowest = 0.0F;
  bool two_sided = false;
  const std::vector<std::uint32_t> corners = corners_of(scene);
  for (std::uint32_t t = 0; t < scene.triangles.size(); ++t) {
    two_sided |= scene.objects[scene.triangle_object[t]].two_sided;
    for (const std::uint32_t corner : corners) {
      const float height = height_above(world, t, scene.vertices[corner]);
      highest = std::max(highest, height);
      lowest = std::min(lowest, height);
    }
  }
  if (highest > tolerance) return Arrangement::convex_room;
  return two_sided && lowest < -tolerance ? Arrangement::general : Arrangement::no_mutual_sight;
}

bool lights_may_be_hidden(const World& world, Arrangement arrangement, bool sealed, const Lighting& lighting) {
  if (arrangement == Arrangement::general) return true;
  if (arrangement == Arrangement::no_mutual_sight) return false;
  for (const Light& light : lighting.lights) {
    const Vec3* position = parts_of(light).position;
    if (position != nullptr ? !is_inside(world, *position) : !sealed) return true;
  }
  return false;
}

}  // namespace gibench
