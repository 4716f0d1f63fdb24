#include "methods/antiradiance/exchange.h"

#include <algorithm>
#include <cmath>

#include "common/finite_elements/polygon_form_factor.h"

namespace gibench::antiradiance {

namespace {

constexpr float disc_radii = 8.0F, cell_radii = 3.0F;                // of both discs together, or of the larger
constexpr float one_level = 1.0F / 16.0F, two_levels = 1.0F / 5.0F;  // of the distance
constexpr std::size_t node_chunk = 64;
constexpr std::size_t point_stride = 2;  // of a cell's points

/// Form factor from a surface element to the cell of j by its points, each of which stands for a share of the disc; bounded at
/// any distance.
float factor_to_points(const Vec3& from, const Vec3& normal, const Elements& elements, std::uint32_t j, bool back_j) {
  const auto points = elements.points(j);
  float exposed = 0.0F, sum = 0.0F;
  for (const CellPoint& point : points)
    if (point.exposed) exposed += 1.0F;
  const float area = elements.disc(j).area / std::max(1.0F, exposed);
  for (const CellPoint& point : points) {
    if (!point.exposed) continue;
    const Vec3 d = (back_j ? point.behind : point.origin) - from;
    const float squared = glm::dot(d, d), u = glm::dot(normal, d), v = glm::dot(point.normal, d) * (back_j ? 1.0F : -1.0F);
    if (u > 0.0F && v > 0.0F) sum += u * v * area / (squared * (pi * squared + area));
  }
  return std::min(1.0F, sum);
}

/// Area of i times the mean form factor of its exposed points to the cell of j.
float one_way(const Elements& elements, std::uint32_t i, bool back_i, std::uint32_t j, bool back_j) {
  const auto points = elements.points(i);
  float sum = 0.0F, of_points = 0.0F, count = 0.0F;
  for (std::size_t k = 0; k < points.size(); k += point_stride) {
    const CellPoint& point = points[k];
    if (!point.exposed) continue;
    count += 1.0F;
    const Vec3& from = back_i ? point.behind : point.origin;
    const Vec3 normal = back_i ? -point.normal : point.normal;
    if (elements.parts(j).empty()) {
      of_points += factor_to_points(from, normal, elements, j, back_j);
      continue;
    }
    for (const CellPart& part : elements.parts(j))
      if ((glm::dot(part.normal, from - part.corners[0]) < 0.0F) == back_j)
        sum += polygon_form_factor(from, normal, part.corners);
  }
  return count > 0.0F ? elements.disc(i).area * (elements.exposed_share(j) * sum + of_points) / count : 0.0F;
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

namespace {

/// One way of looking at two nodes: as discs whose given sides face each other; nothing where they do not.
float sided_exchange(const Node& p, const Node& q, const Sender& sides) {
  const Vec3 d = q.centre - p.centre;
  if ((glm::dot(p.normal, d) < 0.0F) != sides.to_back() || (glm::dot(q.normal, d) > 0.0F) != sides.from_back()) return 0.0F;
  return disc_exchange(p.disc(), q.disc());
}

/// The same over the discs of descendants, `levels` below both.
float exchange_of_descendants(std::span<const Node> nodes, std::uint32_t p, std::uint32_t q, const Sender& sides, int levels) {
  const bool split_p = levels > 0 && !nodes[p].is_leaf(), split_q = levels > 0 && !nodes[q].is_leaf();
  if (!split_p && !split_q) return sided_exchange(nodes[p], nodes[q], sides);
  float sum = 0.0F;
  for (const std::uint32_t child_p : {p + 1, nodes[p].right}) {
    for (const std::uint32_t child_q : {q + 1, nodes[q].right}) {
      sum += exchange_of_descendants(nodes, split_p ? child_p : p, split_q ? child_q : q, sides, levels - 1);
      if (!split_q) break;
    }
    if (!split_p) break;
  }
  return sum;
}

/// How far below a pair to look: by the larger node's extent over the distance.
int levels_below(const Node& p, const Node& q, float distance) {
  const float extent = std::max(p.reach, q.reach);
  if (extent > two_levels * distance) return 2;
  return extent > one_level * distance ? 1 : 0;
}

/// Whether the oracle's form factor of two discs does not do.
bool is_near(const Node& p, const Node& q) {
  const float distance = glm::length(q.centre - p.centre);
  if (!p.is_leaf() || !q.is_leaf()) return levels_below(p, q, distance) > 0;
  return distance <= disc_radii * std::sqrt(std::max(p.area, q.area) / pi);
}

}  // namespace

float node_exchange(const Elements& elements, const Hierarchy& hierarchy, bool cells, std::uint32_t p, const Sender& sender) {
  const auto nodes = hierarchy.nodes();
  const std::uint32_t q = sender.node();
  const Disc to = nodes[p].disc(), from = nodes[q].disc();
  const float distance = glm::length(from.centre - to.centre);
  if (!nodes[p].is_leaf() || !nodes[q].is_leaf())
    return exchange_of_descendants(nodes, p, q, sender, levels_below(nodes[p], nodes[q], distance));
  if (cells && distance < cell_radii * (std::sqrt(to.area / pi) + std::sqrt(from.area / pi)) && !nearly_coplanar(to, from))
    return cell_exchange(elements, hierarchy.element(nodes[p]), sender.to_back(), hierarchy.element(nodes[q]),
                         sender.from_back());
  return sided_exchange(nodes[p], nodes[q], sender);
}

void refine_factors(const Elements& elements, const Hierarchy& hierarchy, bool cells, LinkTable& links, Task& task) {
  const auto nodes = hierarchy.nodes();
  task.parallel_chunks(nodes.size(), node_chunk, [&](const ChunkRange& range) {
    for (auto p = static_cast<std::uint32_t>(range.begin); p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link)
        if (is_near(nodes[p], nodes[links.senders[link].node()]))
          links.factors[link] = node_exchange(elements, hierarchy, cells, p, links.senders[link]) / nodes[p].area;
  });
}

}  // namespace gibench::antiradiance
