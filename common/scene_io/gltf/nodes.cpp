#include "common/scene_io/gltf/nodes.h"

#include <cmath>

namespace gibench {

namespace {

Transform combined(const Transform& outer, const Transform& inner) {
  return {outer.linear * inner.linear, outer.apply(inner.translation)};
}

bool is_in_range(const Transform& transform) {
  constexpr double most = 1e30;
  bool all = true;
  for (int axis = 0; axis < 3; ++axis) {
    all = all && std::fabs(transform.translation[axis]) < most;
    for (int row = 0; row < 3; ++row) all = all && std::fabs(transform.linear[axis][row]) < most;
  }
  return all;
}

/// Of a quaternion x, y, z, w of any length but zero. GLM takes columns.
glm::dmat3 rotation_of(const std::array<double, 4>& q, const GltfValue& node) {
  const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
  if (!(length > 0.0)) node.refuse("has a rotation of length 0");
  const double x = q[0] / length, y = q[1] / length, z = q[2] / length, w = q[3] / length;
  return {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y + z * w),       2.0 * (x * z - y * w),
          2.0 * (x * y - z * w),       1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z + x * w),
          2.0 * (x * z + y * w),       2.0 * (y * z - x * w),       1.0 - 2.0 * (x * x + y * y)};
}

/// A matrix by columns, or scale, then rotation, then translation (glTF 2.0, 3.5.3).
Transform local_transform(const GltfValue& node) {
  if (const auto matrix = node.find("matrix")) {
    const auto m = matrix->numbers<16>();
    return {{m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
  }
  const auto scale = node.numbers_or<3>("scale", {1.0, 1.0, 1.0});
  const auto t = node.numbers_or<3>("translation", {0.0, 0.0, 0.0});
  glm::dmat3 linear = rotation_of(node.numbers_or<4>("rotation", {0.0, 0.0, 0.0, 1.0}), node);
  for (int axis = 0; axis < 3; ++axis) linear[axis] *= scale[static_cast<std::size_t>(axis)];
  return {linear, {t[0], t[1], t[2]}};
}

std::vector<std::size_t> indices_of(const std::optional<GltfValue>& list) {
  std::vector<std::size_t> indices;
  for (std::size_t i = 0; list && i < list->size(); ++i) indices.push_back(list->at(i).whole_number());
  return indices;
}

/// Nodes that are no node's child.
std::vector<std::size_t> all_roots(const GltfDocument& document) {
  std::vector<bool> is_child(document.count("nodes"), false);
  for (std::size_t n = 0; n < is_child.size(); ++n)
    for (const std::size_t child : indices_of(document.item("nodes", n).find("children")))
      if (child < is_child.size()) is_child[child] = true;
  std::vector<std::size_t> roots;
  for (std::size_t n = 0; n < is_child.size(); ++n)
    if (!is_child[n]) roots.push_back(n);
  return roots;
}

}  // namespace

std::vector<GltfNode> scene_nodes(const GltfDocument& document) {
  const bool has_scene = document.count("scenes") > 0;
  const std::vector<std::size_t> roots =
      has_scene ? indices_of(document.item("scenes", document.root().whole_number_or("scene", 0)).find("nodes"))
                : all_roots(document);
  struct Open {
    std::size_t index;
    Transform parent;
  };
  std::vector<Open> open;  // without recursion, for chains of any length
  const auto put = [&](const std::vector<std::size_t>& indices, const Transform& parent) {
    for (std::size_t i = indices.size(); i-- > 0;) open.push_back({indices[i], parent});
  };
  std::vector<GltfNode> nodes;
  std::vector<bool> is_met(document.count("nodes"), false);
  put(roots, {});
  while (!open.empty()) {
    const Open next = open.back();
    open.pop_back();
    const GltfValue value = document.item("nodes", next.index);
    if (is_met[next.index]) value.refuse("is met twice: it is its own descendant or has two parents");
    is_met[next.index] = true;
    nodes.push_back({value, combined(next.parent, local_transform(value))});
    if (!is_in_range(nodes.back().to_file)) value.refuse("has a transform that is larger than single precision can hold");
    put(indices_of(value.find("children")), nodes.back().to_file);
  }
  return nodes;
}

}  // namespace gibench
