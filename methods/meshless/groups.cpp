#include "methods/meshless/groups.h"

#include <algorithm>
#include <map>
#include <set>
#include <tuple>

#include "methods/meshless/components.h"

namespace gibench::meshless {

namespace {

constexpr std::uint32_t no_component = 0xffffffffU;

/// What parts the sides of one Object::group.
struct SideKey {
  std::uint32_t component = no_component;
  bool back = false, sealed = false;
};

bool two_sided(const Scene& scene, std::size_t triangle) { return scene.objects[scene.triangle_object[triangle]].two_sided; }

/// A number for every Object::group and key, in the order in which they appear. The black back of a one-sided object is of its
/// front's group.
Groups by_group_and(const World& world, const std::vector<SideKey>& keys) {
  const Scene& scene = world.scene();
  Groups groups;
  groups.world = &world;
  const std::vector<std::uint32_t> names = group_numbers(scene);
  std::map<std::tuple<std::uint32_t, std::uint32_t, bool, bool>, std::uint32_t> numbers;
  groups.of_side.reserve(keys.size());
  for (std::size_t side = 0; side < keys.size(); ++side) {
    const std::uint32_t name = names[scene.triangle_object[side / 2]];
    const SideKey& key = keys[two_sided(scene, side / 2) ? side : side / 2 * 2];
    const auto [found, added] = numbers.try_emplace({name, key.component, key.back, key.sealed}, groups.count);
    if (added) {
      ++groups.count;
      groups.sealed.push_back(key.sealed ? 1 : 0);
    }
    groups.of_side.push_back(found->second);
  }
  return groups;
}

/// Those of the largest area; of equal ones, those that appear first.
std::set<std::uint32_t> largest_of(const Groups& groups, std::size_t most) {
  std::vector<double> area(groups.count, 0.0);
  for (std::size_t side = 0; side < groups.of_side.size(); ++side)
    if (side % 2 == 0 || two_sided(groups.world->scene(), side / 2))
      area[groups.of_side[side]] += static_cast<double>(groups.world->area(static_cast<std::uint32_t>(side / 2)));
  std::vector<std::uint32_t> order(groups.count);
  for (std::uint32_t group = 0; group < groups.count; ++group) order[group] = group;
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return area[a] > area[b]; });
  order.resize(std::min(most, order.size()));
  return {order.begin(), order.end()};
}

}  // namespace

Groups make_groups(const World& world, Grouping grouping, const SideLight* light) {
  std::vector<SideKey> keys(2 * world.scene().triangles.size());
  if (grouping == Grouping::objects) return by_group_and(world, keys);
  const std::vector<std::uint32_t> component = connected_components(world);
  for (std::size_t side = 0; side < keys.size(); ++side) {
    const auto triangle = static_cast<std::uint32_t>(side / 2);
    const bool front = side % 2 == 0;
    const bool sealed = light != nullptr && world.area(triangle) > 0.0F && !light->is_reached(triangle, front);
    keys[side] = {sealed ? no_component : component[triangle], !front, sealed};
  }
  const Groups all = by_group_and(world, keys);
  if (grouping == Grouping::components || all.count <= most_own_groups) return all;
  const std::set<std::uint32_t> kept = largest_of(all, most_own_groups);
  for (std::size_t side = 0; side < keys.size(); ++side)
    keys[side].component = kept.contains(all.of_side[side]) ? all.of_side[side] : no_component;
  return by_group_and(world, keys);
}

}  // namespace gibench::meshless
