/// The faces of an OBJ file as triangles.
#pragma once

#include <span>

#include "common/scene/polygon.h"
#include "common/scene_io/obj/obj_text.h"

namespace gibench {

/// Calls visit(a, b, c) with the corners of triangles that cover the faces of a part.
template <class Visit>
void for_each_triangle(const ObjText& obj, const ObjText::Part& part, const Visit& visit) {
  std::size_t begin = 0;
  std::vector<Vec3d> positions;
  for (const std::uint32_t end : part.face_ends) {
    const std::span<const ObjText::Corner> face(&part.corners[begin], end - begin);
    begin = end;
    if (face.size() <= 4) {
      visit(face[0], face[1], face[2]);
      if (face.size() == 4) visit(face[0], face[2], face[3]);
      continue;
    }
    positions.clear();
    for (const ObjText::Corner& corner : face) positions.push_back(obj.positions[corner.position]);
    for (const auto& [a, b, c] : triangulate_polygon(positions)) visit(face[a], face[b], face[c]);
  }
}

}  // namespace gibench
