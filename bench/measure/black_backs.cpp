#include "bench/measure/black_backs.h"

#include <fmt/format.h>

#include <algorithm>

#include "common/core/names.h"

namespace gibench {

std::string warning_of_black_backs(const World& world, const CameraPoints& points) {
  const Scene& scene = world.scene();
  std::vector<std::size_t> backs(scene.objects.size(), 0);
  std::size_t all = 0;
  for (std::size_t i = 0; i < points.samples.size(); ++i) {
    const std::uint32_t triangle = points.samples[i].triangle, object = scene.triangle_object[triangle];
    if (scene.objects[object].two_sided || glm::dot(world.normal(triangle), points.toward_viewer[i]) >= 0.0F) continue;
    ++backs[object], ++all;
  }
  if (points.samples.empty() || 2 * all < points.samples.size()) return {};
  const auto most = std::ranges::max_element(backs);
  return fmt::format(
      "the camera sees mostly black backs of one-sided objects ({:.0f}% of what it sees, most of them of {}): is the model "
      "inside "
      "out? gibench check tells",
      100.0 * static_cast<double>(all) / static_cast<double>(points.samples.size()),
      in_quotes(scene.objects[static_cast<std::size_t>(most - backs.begin())].name));
}

}  // namespace gibench
