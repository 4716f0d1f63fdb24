/// Numbers in the buffers of a glTF document.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "common/scene_io/gltf/document.h"

namespace gibench {

/// Rows of equally many numbers.
struct AccessorValues {
  std::size_t components = 0;
  std::vector<double> values;

  std::size_t count() const { return components > 0 ? values.size() / components : 0; }
  const double* row(std::size_t index) const { return values.data() + index * components; }
};

/// Vectors of 1 to 4 numbers of any component type (KHR_mesh_quantization); normalised integers become [−1, 1] or
/// [0, 1] (glTF 2.0, 3.11); sparse values are put in their places. InputError where the accessor is not within its buffer
/// or no such vector.
AccessorValues read_accessor(GltfDocument& document, std::size_t accessor);

/// Whole numbers from 0, one per row: indices of vertices.
std::vector<std::uint32_t> read_indices(GltfDocument& document, std::size_t accessor);

}  // namespace gibench
