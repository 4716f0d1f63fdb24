#include "methods/meshless/groups.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <string>
#include <utility>

namespace gibench::meshless {

namespace {

/// Disjoint sets of vertices; the smallest number of a set stands for it.
class VertexSets {
 public:
  explicit VertexSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::uint32_t find(std::uint32_t v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }
  void join(std::uint32_t a, std::uint32_t b) {
    a = find(a), b = find(b);
    if (a != b) parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

void join_coinciding(const std::vector<Vec3>& vertices, VertexSets& sets) {
  std::vector<std::uint32_t> order(vertices.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) { return std::tie(vertices[i].x, vertices[i].y, vertices[i].z); };
  std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return key(a) < key(b); });
  for (std::size_t i = 1; i < order.size(); ++i)
    if (vertices[order[i]] == vertices[order[i - 1]]) sets.join(order[i], order[i - 1]);
}

Groups by_component(const Scene& scene) {
  VertexSets sets(scene.vertices.size());
  join_coinciding(scene.vertices, sets);
  for (const Triangle& triangle : scene.triangles) {
    sets.join(triangle.corners[0], triangle.corners[1]);
    sets.join(triangle.corners[0], triangle.corners[2]);
  }
  Groups groups;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> numbers;
  groups.of_triangle.reserve(scene.triangles.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const std::string& name = scene.objects[scene.triangle_object[t]].group;
    const auto [found, added] = numbers.try_emplace({name, sets.find(scene.triangles[t].corners[0])}, groups.count);
    if (added) ++groups.count;
    groups.of_triangle.push_back(found->second);
  }
  return groups;
}

Groups by_object(const Scene& scene) {
  Groups groups;
  std::map<std::string, std::uint32_t> numbers;
  groups.of_triangle.reserve(scene.triangles.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const auto [found, added] = numbers.try_emplace(scene.objects[scene.triangle_object[t]].group, groups.count);
    if (added) ++groups.count;
    groups.of_triangle.push_back(found->second);
  }
  return groups;
}

}  // namespace

Groups make_groups(const World& world, Grouping grouping) {
  if (grouping == Grouping::objects) return by_object(world.scene());
  Groups groups = by_component(world.scene());
  if (grouping == Grouping::automatic && groups.count > few_components) return by_object(world.scene());
  return groups;
}

}  // namespace gibench::meshless
