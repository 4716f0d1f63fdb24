#include "methods/meshless/groups.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>

#include "methods/meshless/components.h"

namespace gibench::meshless {

namespace {

constexpr std::uint32_t no_component = 0xffffffffU;

/// A number for every triangle's Object::group and component, in the order in which they appear.
Groups by_group_and(const Scene& scene, const std::vector<std::uint32_t>& component) {
  Groups groups;
  std::map<std::pair<std::string, std::uint32_t>, std::uint32_t> numbers;
  groups.of_triangle.reserve(scene.triangles.size());
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const std::string& name = scene.objects[scene.triangle_object[t]].group;
    const auto [found, added] = numbers.try_emplace({name, component[t]}, groups.count);
    if (added) ++groups.count;
    groups.of_triangle.push_back(found->second);
  }
  return groups;
}

/// Those of the largest area; of equal ones, those that appear first.
std::set<std::uint32_t> largest_of(const World& world, const Groups& groups, std::size_t most) {
  std::vector<double> area(groups.count, 0.0);
  for (std::uint32_t t = 0; t < groups.of_triangle.size(); ++t) area[groups.of_triangle[t]] += static_cast<double>(world.area(t));
  std::vector<std::uint32_t> order(groups.count);
  for (std::uint32_t group = 0; group < groups.count; ++group) order[group] = group;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  order.resize(std::min(most, order.size()));
  return {order.begin(), order.end()};
}

}  // namespace

Groups make_groups(const World& world, Grouping grouping) {
  const Scene& scene = world.scene();
  std::vector<std::uint32_t> component(scene.triangles.size(), no_component);
  if (grouping == Grouping::objects) return by_group_and(scene, component);
  const Groups all = by_group_and(scene, connected_components(world));
  if (grouping == Grouping::components || all.count <= most_own_groups) return all;
  const std::set<std::uint32_t> kept = largest_of(world, all, most_own_groups);
  for (std::size_t t = 0; t < component.size(); ++t)
    if (kept.contains(all.of_triangle[t])) component[t] = all.of_triangle[t];
  return by_group_and(scene, component);
}

}  // namespace gibench::meshless
