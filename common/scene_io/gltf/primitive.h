/// The triangles of a mesh primitive of a glTF document.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/core/vec.h"
#include "common/scene/scene_assembler.h"
#include "common/scene_io/gltf/accessor.h"

namespace gibench {

/// Vertices and triangles as the file has them, before the node's transform.
struct GltfPrimitive {
  GltfValue value;
  std::vector<Vec3d> positions;  ///< with the morph targets' weights applied
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool is_surface = true;  ///< false for points and lines, which have no triangles

  std::optional<std::size_t> material() const { return value.whole_number_if("material"); }
  /// The values of an attribute, one row per vertex; nothing where the primitive has none of that name.
  std::optional<AccessorValues> attribute(GltfDocument& document, const char* name) const;
  /// Of each triangle, before the node's transform.
  std::vector<double> areas() const;
};

/// Triangles, strips and fans. Each position becomes position + Σ weight · target. InputError for an index past the end
/// of the vertices, or attributes of other lengths.
GltfPrimitive read_primitive(GltfDocument& document, const GltfValue& value, const std::vector<double>& morph_weights);

/// The faces that the primitive gives. Vertices stay those of the file; where it has one for each corner of each triangle,
/// those at equal positions are joined.
ObjectGeometry geometry_of(const GltfPrimitive& primitive);

}  // namespace gibench
