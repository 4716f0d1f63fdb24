#include "common/scene/object_faces.h"

#include "common/core/error.h"
#include "common/scene/polygon.h"

namespace gibench {

void add_face(std::span<const std::uint32_t> corners, ObjectGeometry& geometry) {
  GIBENCH_CHECK(corners.size() >= 3 && corners.size() <= most_corners, "a face has 3 to 10 000 corners");
  if (corners.size() <= 4) {
    geometry.faces.push_back({{corners[0], corners[1], corners[2], corners.back()}});
    return;
  }
  std::vector<Vec3d> polygon;
  for (const std::uint32_t corner : corners) polygon.push_back(geometry.vertices[corner]);
  for (const auto& [a, b, c] : triangulate_polygon(polygon))
    geometry.faces.push_back({{corners[a], corners[b], corners[c], corners[c]}});
}

}  // namespace gibench
