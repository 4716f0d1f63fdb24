#include "common/scene_io/gltf/accessor.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace gibench {

namespace {

// Rows of zeros that no byte of a file stands for: 4 M vertices, so that a small file cannot ask for all memory.
constexpr std::size_t most_zeros = std::size_t{1} << 22U;

/// A component's type, as glTF numbers them.
enum class Component { int8 = 5120, uint8 = 5121, int16 = 5122, uint16 = 5123, uint32 = 5125, float32 = 5126 };

std::size_t bytes_of(Component type) {
  switch (type) {
    case Component::int8:
    case Component::uint8: return 1;
    case Component::int16:
    case Component::uint16: return 2;
    case Component::uint32:
    case Component::float32: return 4;
  }
  return 0;
}

Component component_of(const GltfValue& value) {
  const std::size_t code = value.whole_number();
  for (const Component type :
       {Component::int8, Component::uint8, Component::int16, Component::uint16, Component::uint32, Component::float32})
    if (code == static_cast<std::size_t>(type)) return type;
  value.refuse("is " + std::to_string(code) + ", which is no component type");
}

/// Indices are whole numbers without a sign (glTF 2.0, 3.7.2.1 and 3.6.2.3).
Component index_component_of(const GltfValue& value) {
  const Component type = component_of(value);
  switch (type) {
    case Component::uint8:
    case Component::uint16:
    case Component::uint32: return type;
    case Component::int8:
    case Component::int16:
    case Component::float32: break;
  }
  value.refuse("is " + std::to_string(static_cast<int>(type)) + ", which is no type of indices");
}

std::size_t vector_size(const GltfValue& type) {
  const std::string name = type.text();
  constexpr std::array<std::string_view, 4> names{"SCALAR", "VEC2", "VEC3", "VEC4"};
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) type.refuse("is \"" + name + "\", where SCALAR, VEC2, VEC3 or VEC4 belongs");
  return static_cast<std::size_t>(found - names.begin()) + 1;
}

template <class T>
T read_as(const char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

/// Rows within a bufferView.
struct Rows {
  std::string_view bytes;  ///< from the first row to the end of the view
  std::size_t stride = 0, count = 0, components = 0;
  Component type = Component::float32;

  double value(std::size_t row, std::size_t component) const {
    const char* at = bytes.data() + row * stride + component * bytes_of(type);
    switch (type) {
      case Component::int8: return read_as<std::int8_t>(at);
      case Component::uint8: return read_as<std::uint8_t>(at);
      case Component::int16: return read_as<std::int16_t>(at);
      case Component::uint16: return read_as<std::uint16_t>(at);
      case Component::uint32: return read_as<std::uint32_t>(at);
      case Component::float32: return static_cast<double>(read_as<float>(at));
    }
    return 0.0;
  }
};

/// `owner` names the bufferView and byteOffset; held against the view before anything is read.
Rows rows_of(GltfDocument& document, const GltfValue& owner, Component type, std::size_t components, std::size_t count,
             bool may_stride) {
  const std::size_t view = owner.at("bufferView").whole_number(), offset = owner.whole_number_or("byteOffset", 0);
  Rows rows{document.view_bytes(view), components * bytes_of(type), count, components, type};
  const std::size_t row_bytes = rows.stride, available = rows.bytes.size();
  if (may_stride) rows.stride = document.item("bufferViews", view).whole_number_or("byteStride", row_bytes);
  if (rows.stride < row_bytes || rows.stride > 65536)
    owner.refuse("has rows of " + std::to_string(row_bytes) + " bytes, " + std::to_string(rows.stride) + " apart");
  // The first test keeps the product small.
  if (count > available || offset > available || (count > 0 && (count - 1) * rows.stride + row_bytes > available - offset))
    owner.refuse(
        "has " + std::to_string(count) + " rows of " + std::to_string(row_bytes) + " bytes, and its bufferView ends before",
        "it is cut short or damaged; copy or export it again");
  rows.bytes.remove_prefix(offset);
  return rows;
}

/// glTF 2.0, 3.11: [−1, 1] of signed integers, whose lowest is −1 too, [0, 1] of unsigned ones.
double normalised(double value, Component type) {
  switch (type) {
    case Component::int8: return std::max(value / 127.0, -1.0);
    case Component::uint8: return value / 255.0;
    case Component::int16: return std::max(value / 32767.0, -1.0);
    case Component::uint16: return value / 65535.0;
    case Component::uint32: return value / 4294967295.0;
    case Component::float32: return value;
  }
  return value;
}

/// Replaces some rows (glTF 2.0, 3.6.2.3).
void apply_sparse(GltfDocument& document, const GltfValue& sparse, Component type, AccessorValues& values) {
  const std::size_t count = sparse.at("count").whole_number();
  const GltfValue indices = sparse.at("indices");
  const Component index_type = index_component_of(indices.at("componentType"));
  const Rows places = rows_of(document, indices, index_type, 1, count, /*may_stride=*/false);
  const Rows rows = rows_of(document, sparse.at("values"), type, values.components, count, /*may_stride=*/false);
  for (std::size_t i = 0; i < count; ++i) {
    const auto place = static_cast<std::size_t>(places.value(i, 0));
    if (place >= values.count())
      indices.refuse("has index " + std::to_string(place) + ", and there are " + std::to_string(values.count()) + " rows");
    for (std::size_t c = 0; c < values.components; ++c) values.values[place * values.components + c] = rows.value(i, c);
  }
}

}  // namespace

AccessorValues read_accessor(GltfDocument& document, std::size_t index) {
  const GltfValue accessor = document.item("accessors", index);
  const Component type = component_of(accessor.at("componentType"));
  const std::size_t count = accessor.at("count").whole_number();
  AccessorValues result;
  result.components = vector_size(accessor.at("type"));
  const auto sparse = accessor.find("sparse");
  if (accessor.has("bufferView")) {
    const Rows rows = rows_of(document, accessor, type, result.components, count, /*may_stride=*/true);
    result.values.reserve(count * result.components);
    for (std::size_t row = 0; row < count; ++row)
      for (std::size_t c = 0; c < result.components; ++c) result.values.push_back(rows.value(row, c));
  } else {
    if (!sparse) accessor.refuse("has no data", "export it without compression");
    if (count > most_zeros)
      accessor.refuse("has " + std::to_string(count) + " rows without data", "export it without sparse accessors");
    result.values.assign(count * result.components, 0.0);
  }
  if (sparse) apply_sparse(document, *sparse, type, result);
  if (accessor.flag_or("normalized", false))
    for (double& value : result.values) value = normalised(value, type);
  return result;
}

std::vector<std::uint32_t> read_indices(GltfDocument& document, std::size_t index) {
  const GltfValue accessor = document.item("accessors", index);
  index_component_of(accessor.at("componentType"));
  const AccessorValues values = read_accessor(document, index);
  if (values.components != 1)
    accessor.refuse("has " + std::to_string(values.components) + " numbers per row, where indices have one");
  std::vector<std::uint32_t> indices;
  indices.reserve(values.values.size());
  for (const double value : values.values) indices.push_back(static_cast<std::uint32_t>(value));
  return indices;
}

}  // namespace gibench
