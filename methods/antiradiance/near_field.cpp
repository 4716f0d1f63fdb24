#include "methods/antiradiance/near_field.h"

#include <algorithm>
#include <cmath>

namespace gibench::antiradiance {

namespace {

constexpr float disc_radii = 8.0F, cell_radii = 3.0F;  // of both discs together, or of the larger
constexpr std::size_t node_chunk = 64;
constexpr std::size_t point_stride = 2;  // of a cell's points

/// Area of i times the mean form factor of its exposed points to the cell of j.
float one_way(const Elements& elements, std::uint32_t i, bool back_i, std::uint32_t j, bool back_j) {
  const auto points = elements.points(i);
  float sum = 0.0F, count = 0.0F;
  for (std::size_t k = 0; k < points.size(); k += point_stride) {
    const CellPoint& point = points[k];
    if (!point.exposed) continue;
    count += 1.0F;
    const Vec3& from = back_i ? point.behind : point.origin;
    const Vec3 normal = back_i ? -point.normal : point.normal;
    for (const CellPart& part : elements.parts(j))
      if ((glm::dot(part.normal, from - part.corners[0]) < 0.0F) == back_j)
        sum += polygon_form_factor(from, normal, part.corners);
  }
  return count > 0.0F ? elements.disc(i).area * elements.exposed_share(j) * sum / count : 0.0F;
}

bool nearly_coplanar(const Disc& a, const Disc& b) {
  const Vec3 d = b.centre - a.centre;
  const float heights = std::fabs(glm::dot(a.normal, d)) + std::fabs(glm::dot(b.normal, d));
  return glm::dot(a.normal, b.normal) > 0.94F && heights < 0.1F * glm::length(d);
}

}  // namespace

float cell_exchange(const Elements& elements, std::uint32_t i, bool back_i, std::uint32_t j, bool back_j) {
  const float both = 0.5F * (one_way(elements, i, back_i, j, back_j) + one_way(elements, j, back_j, i, back_i));
  return std::min(both, std::min(elements.disc(i).area, elements.disc(j).area));
}

void correct_near_field(const Elements& elements, const Hierarchy& hierarchy, bool cells, LinkTable& links, Task& task) {
  const auto nodes = hierarchy.nodes();
  task.parallel_chunks(nodes.size(), node_chunk, [&](const ChunkRange& range) {
    for (std::size_t p = range.begin; p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link) {
        const Sender sender = links.senders[link];
        const Disc to = nodes[p].disc(), from = nodes[sender.node()].disc();
        const Vec3 d = from.centre - to.centre;
        const float squared = pi * glm::dot(d, d), larger = std::max(to.area, from.area);
        if (squared > disc_radii * disc_radii * larger) continue;
        const bool leaves = nodes[p].is_leaf() && nodes[sender.node()].is_leaf();
        const float reach = cell_radii * (std::sqrt(to.area) + std::sqrt(from.area));
        const float exchange = cells && leaves && squared < reach * reach && !nearly_coplanar(to, from)
                                   ? cell_exchange(elements, hierarchy.element(nodes[p]), sender.to_back(),
                                                   hierarchy.element(nodes[sender.node()]), sender.from_back())
                                   : disc_exchange(to, from);
        links.factors[link] = exchange / to.area;
      }
  });
}

}  // namespace gibench::antiradiance
