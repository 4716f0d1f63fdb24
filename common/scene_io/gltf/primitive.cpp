#include "common/scene_io/gltf/primitive.h"

#include <cstring>
#include <string>
#include <unordered_map>

#include "common/core/hash.h"

namespace gibench {

namespace {

// Kinds of primitives (glTF 2.0, 3.7.2.1); those below are points and lines.
constexpr std::size_t triangles_mode = 4, strip_mode = 5, fan_mode = 6;

using Triangles = std::vector<std::array<std::uint32_t, 3>>;

AccessorValues read_vectors(GltfDocument& document, const GltfValue& accessor, std::size_t vertices) {
  AccessorValues values = read_accessor(document, accessor.whole_number());
  if (values.components != 3) accessor.refuse("is a list of " + std::to_string(values.components) + " numbers per vertex, not 3");
  if (values.count() != vertices)
    accessor.refuse("has " + std::to_string(values.count()) + " rows for " + std::to_string(vertices) + " vertices");
  return values;
}

std::vector<Vec3d> read_positions(GltfDocument& document, const GltfValue& accessor) {
  const std::size_t vertices = document.item("accessors", accessor.whole_number()).at("count").whole_number();
  const AccessorValues values = read_vectors(document, accessor, vertices);
  std::vector<Vec3d> positions(vertices);
  for (std::size_t i = 0; i < vertices; ++i) positions[i] = {values.row(i)[0], values.row(i)[1], values.row(i)[2]};
  return positions;
}

void apply_morph_targets(GltfDocument& document, const GltfValue& primitive, const std::vector<double>& weights,
                         std::vector<Vec3d>& positions) {
  const auto targets = primitive.find("targets");
  if (!targets) return;
  for (std::size_t t = 0; t < targets->size() && t < weights.size(); ++t) {
    if (weights[t] == 0.0) continue;
    const auto moves = targets->at(t).find("POSITION");
    if (!moves) continue;
    const AccessorValues offsets = read_vectors(document, *moves, positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
      positions[i] += weights[t] * Vec3d(offsets.row(i)[0], offsets.row(i)[1], offsets.row(i)[2]);
  }
}

std::vector<std::uint32_t> corner_indices(GltfDocument& document, const GltfValue& primitive, std::size_t vertices) {
  const auto accessor = primitive.find("indices");
  std::vector<std::uint32_t> corners;
  if (accessor) {
    corners = read_indices(document, accessor->whole_number());
  } else {
    corners.resize(vertices);
    for (std::size_t i = 0; i < vertices; ++i) corners[i] = static_cast<std::uint32_t>(i);
  }
  for (const std::uint32_t corner : corners)
    if (corner >= vertices)
      accessor->refuse("has a vertex index out of range: " + std::to_string(corner) + ", and there are " +
                       std::to_string(vertices) + " vertices");
  return corners;
}

/// glTF 2.0, 3.7.2.1: every second triangle of a strip is turned, so that all wind one way.
Triangles triangles_of(const std::vector<std::uint32_t>& corners, std::size_t mode, const GltfValue& primitive) {
  Triangles triangles;
  if (mode == triangles_mode && corners.size() % 3 != 0)
    primitive.refuse("has " + std::to_string(corners.size()) + " corners, which make no whole triangles");
  const std::size_t step = mode == triangles_mode ? 3 : 1;
  triangles.reserve(corners.size() / step);
  for (std::size_t i = 0; i + 2 < corners.size(); i += step) {
    const bool is_turned = mode == strip_mode && i % 2 == 1;
    const std::uint32_t first = mode == fan_mode ? corners[0] : corners[i];
    const std::uint32_t second = corners[is_turned ? i + 2 : i + 1], third = corners[is_turned ? i + 1 : i + 2];
    const bool links_a_strip = mode != triangles_mode && (first == second || second == third || third == first);
    if (!links_a_strip) triangles.push_back({first, second, third});
  }
  return triangles;
}

struct HashOfPosition {
  std::size_t operator()(const Vec3d& v) const { return hash_bytes(&v, sizeof v); }
};

/// For each position the index of the first equal one, and those alone.
std::vector<std::uint32_t> join_equal(const std::vector<Vec3d>& positions, std::vector<Vec3d>& joined) {
  std::unordered_map<Vec3d, std::uint32_t, HashOfPosition> known;
  std::vector<std::uint32_t> index_of;
  index_of.reserve(positions.size());
  for (const Vec3d& position : positions) {
    const auto [place, is_new] = known.try_emplace(position + Vec3d(0.0), static_cast<std::uint32_t>(joined.size()));  // −0 is 0
    if (is_new) joined.push_back(position);
    index_of.push_back(place->second);
  }
  return index_of;
}

}  // namespace

std::optional<AccessorValues> GltfPrimitive::attribute(GltfDocument& document, const char* name) const {
  const auto accessor = value.at("attributes").find(name);
  if (!accessor) return std::nullopt;
  AccessorValues values = read_accessor(document, accessor->whole_number());
  if (values.count() != positions.size())
    accessor->refuse("has " + std::to_string(values.count()) + " rows for " + std::to_string(positions.size()) + " vertices");
  return values;
}

std::vector<double> GltfPrimitive::areas() const {
  std::vector<double> result;
  result.reserve(triangles.size());
  for (const auto& [a, b, c] : triangles)
    result.push_back(0.5 * glm::length(glm::cross(positions[b] - positions[a], positions[c] - positions[a])));
  return result;
}

GltfPrimitive read_primitive(GltfDocument& document, const GltfValue& value, const std::vector<double>& morph_weights) {
  GltfPrimitive primitive{value, {}, {}, true};
  const std::size_t mode = value.whole_number_or("mode", triangles_mode);
  if (mode > fan_mode) value.refuse("has mode " + std::to_string(mode) + ", which is no kind of primitive");
  const auto position = value.at("attributes").find("POSITION");
  primitive.is_surface = mode >= triangles_mode;
  if (!position || !primitive.is_surface) return primitive;
  primitive.positions = read_positions(document, *position);
  apply_morph_targets(document, value, morph_weights, primitive.positions);
  primitive.triangles = triangles_of(corner_indices(document, value, primitive.positions.size()), mode, value);
  return primitive;
}

ObjectGeometry geometry_of(const GltfPrimitive& primitive) {
  ObjectGeometry geometry;
  geometry.faces.reserve(primitive.triangles.size());
  std::vector<std::uint32_t> index_of;
  const bool has_own_corners = primitive.positions.size() == 3 * primitive.triangles.size();
  if (has_own_corners) index_of = join_equal(primitive.positions, geometry.vertices);
  else geometry.vertices = primitive.positions;
  const auto corner = [&](std::uint32_t vertex) { return has_own_corners ? index_of[vertex] : vertex; };
  for (const auto& [a, b, c] : primitive.triangles) geometry.faces.push_back({{corner(a), corner(b), corner(c), corner(c)}});
  return geometry;
}

}  // namespace gibench
