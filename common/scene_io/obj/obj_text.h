/// The statements of an OBJ file, before its faces become meshes.
#pragma once

#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <vector>

#include "common/core/vec.h"
#include "common/scene_io/text/model_place.h"

namespace gibench {

/// Positions in file coordinates and faces that index into them. Every index is in range.
struct ObjText {
  static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

  /// A corner of a face: indices into positions and texture_points (or none).
  struct Corner {
    std::uint32_t position = 0, texture_point = none;
  };
  /// The faces of one object or group (`o`, `g`) with one material (`usemtl`).
  struct Part {
    std::uint32_t object = 0, material = none;  ///< indices into object_names and material_names
    std::vector<std::uint32_t> face_ends;       ///< into corners, one for each face
    std::vector<Corner> corners;
  };

  std::vector<Vec3d> positions;
  std::vector<Vec3> colours;  ///< one for each position, or empty
  std::vector<Vec2> texture_points;
  std::vector<Part> parts;  ///< in the order of their first face
  std::vector<std::string> object_names, material_names;
  std::vector<std::string> libraries;  ///< of `mtllib`, the rest of each such line
  std::size_t points_and_lines = 0;
  std::set<std::string> unknown_statements;  ///< those left out
  bool has_weights = false, colours_are_partial = false;
};

/// Reads the text of an OBJ file. Refuses a number or an index that is wrong, by its line, and a file that ends within a
/// position or a face.
ObjText parse_obj(std::string_view text, const ModelPlace& place);

}  // namespace gibench
