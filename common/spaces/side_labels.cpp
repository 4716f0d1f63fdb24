#include "common/spaces/side_labels.h"

#include <map>
#include <string>
#include <tuple>

#include "common/spaces/side_light_making.h"

namespace gibench {

SideLabels::SideLabels(const World& world, const SideLight& light) {
  const Scene& scene = world.scene();
  std::map<std::string, std::uint32_t> groups;
  std::vector<std::uint32_t> group_of_object;
  for (const Object& object : scene.objects)
    group_of_object.push_back(groups.try_emplace(object.group, static_cast<std::uint32_t>(groups.size())).first->second);
  constexpr std::uint32_t kinds = 4;  // of a group: front or back, reached or not
  std::vector<std::uint32_t> label_of_kind(kinds * groups.size(), none);
  labels_.assign(2 * scene.triangles.size(), none);
  for (std::uint32_t side = 0; side < labels_.size(); ++side) {
    const std::uint32_t triangle = side / 2;
    const bool front = side % 2 == 0;
    if (!can_reflect(world, triangle, front) || !(world.area(triangle) > 0.0F)) continue;
    const bool reached = light.is_reached(triangle, front);
    const std::uint32_t kind = kinds * group_of_object[scene.triangle_object[triangle]] + (front ? 0U : 2U) + (reached ? 0U : 1U);
    if (label_of_kind[kind] == none) {
      label_of_kind[kind] = count();
      reached_.push_back(reached ? 1 : 0);
    }
    labels_[side] = label_of_kind[kind];
  }
}

}  // namespace gibench
