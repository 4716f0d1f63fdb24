#include "methods/antiradiance/near_directions.h"

#include <cmath>
#include <cstddef>

#include "common/core/sampling.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t node_chunk = 64;
constexpr float near_radii = 6.0F;    // of both discs together: beyond, a disc fills less than a bin
constexpr std::size_t ends = 4;       // points of a cell
constexpr float by_direction = 0.1F;  // a larger form factor is split by directions, not by points
constexpr std::size_t directions = 64;

struct Row {
  std::vector<std::uint32_t> counts;  ///< of each link's
  std::vector<Sender> senders;
  std::vector<float> factors;
  std::vector<Vec3> ways;
  void add(Sender sender, float factor, const Vec3& way) {
    senders.push_back(sender);
    factors.push_back(factor);
    ways.push_back(way);
  }
};

/// A quarter of the points, spread over the cell.
const CellPoint& end_of(std::span<const CellPoint> points, std::size_t k, std::size_t shift) {
  return points[(k * points.size() / ends + shift) % points.size()];
}

/// Point to a quarter of the sender's disc, bounded at any distance; negative where they look away from each other.
float share_of(const CellPoint& to, const CellPoint& from, const Sender& sides, float area, Vec3& way) {
  const Vec3& origin = sides.to_back() ? to.behind : to.origin;
  const Vec3& source = sides.from_back() ? from.behind : from.origin;
  const Vec3 d = source - origin;
  const float squared = glm::dot(d, d);
  if (!(squared > 0.0F) || !to.exposed || !from.exposed) return -1.0F;
  const float u = glm::dot(to.normal, d) * (sides.to_back() ? -1.0F : 1.0F);
  const float v = -glm::dot(from.normal, d) * (sides.from_back() ? -1.0F : 1.0F);
  if (!(u > 0.0F && v > 0.0F)) return -1.0F;
  way = d * (-1.0F / std::sqrt(squared));
  return u * v / (squared * (pi * squared + area / static_cast<float>(ends)));
}

/// Whether a ray from `origin` meets the part.
bool meets(const CellPart& part, const Vec3& origin, const Vec3& direction) {
  const float across = glm::dot(part.normal, direction);
  const float t = across != 0.0F ? glm::dot(part.normal, part.corners[0] - origin) / across : -1.0F;
  if (!(t > 0.0F)) return false;
  const Vec3 at = origin + direction * t;
  int left = 0, right = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec3 &a = part.corners[k], &b = part.corners[(k + 1) % 4];
    const float side = glm::dot(glm::cross(b - a, at - a), part.normal);
    (side < 0.0F ? right : left) += 1;
  }
  return left == 0 || right == 0;
}

/// Elements so close that every point of one sees the other under most of its directions: by directions, as many as bins are
/// told apart by, from a few points of the receiver.
bool split_by_direction(const Elements& elements, std::uint32_t to, std::uint32_t from, Sender sender, float factor, Row& row) {
  const std::size_t before = row.factors.size();
  float sum = 0.0F;
  for (std::size_t k = 0; k < directions; ++k) {
    const float u = (static_cast<float>(k) + 0.5F) / static_cast<float>(directions), v = 0.61803398875F * static_cast<float>(k);
    const Vec3 local = cosine_hemisphere({u, v - std::floor(v)});
    float hits = 0.0F;
    Vec3 way(0.0F);
    for (std::size_t i = 0; i < ends; ++i) {
      const CellPoint& point = end_of(elements.points(to), i, 0);
      if (!point.exposed) continue;
      const Vec3 direction = Frame(sender.to_back() ? -point.normal : point.normal).to_world(local);
      for (const CellPart& part : elements.parts(from))
        if ((glm::dot(part.normal, direction) > 0.0F) == sender.from_back() &&
            meets(part, sender.to_back() ? point.behind : point.origin, direction)) {
          hits += 1.0F;
          way = -direction;
          break;
        }
    }
    if (hits > 0.0F) row.add(sender, hits, way), sum += hits;
  }
  for (std::size_t k = before; k < row.factors.size(); ++k) row.factors[k] *= factor / sum;
  return sum > 0.0F;
}

void split(const Elements& elements, std::uint32_t to, std::uint32_t from, Sender sender, float factor, const Vec3& between,
           Row& row) {
  if (factor > by_direction && split_by_direction(elements, to, from, sender, factor, row)) return;
  float shares[ends * ends], sum = 0.0F;
  Vec3 ways[ends * ends];
  for (std::size_t i = 0; i < ends; ++i)
    for (std::size_t j = 0; j < ends; ++j) {
      const std::size_t k = i * ends + j;
      shares[k] = share_of(end_of(elements.points(to), i, 0), end_of(elements.points(from), j, 1), sender,
                           elements.disc(from).area, ways[k]);
      if (shares[k] > 0.0F) sum += shares[k];
    }
  if (!(sum > 0.0F)) {
    row.add(sender, factor, between);
    return;
  }
  for (std::size_t k = 0; k < ends * ends; ++k)
    if (shares[k] > 0.0F) row.add(sender, factor * shares[k] / sum, ways[k]);
}

/// Unit direction from one centre to the other.
Vec3 way_between(const Node& from, const Node& to) {
  const Vec3 d = to.centre - from.centre;
  const float distance = glm::length(d);
  return distance > 0.0F ? d / distance : -to.normal;
}

bool near_leaves(const Node& from, const Node& to) {
  return from.is_leaf() && to.is_leaf() &&
         glm::length(to.centre - from.centre) < near_radii * (std::sqrt(to.area / pi) + std::sqrt(from.area / pi));
}

}  // namespace

void split_near_links(const Elements& elements, const Hierarchy& hierarchy, LinkTable& links, std::vector<Vec3>& ways,
                      Task& task) {
  const auto nodes = hierarchy.nodes();
  std::vector<Row> pieces(chunk_count(nodes.size(), node_chunk));  // of near links alone: most links stay as they are
  LinkTable table;
  table.row_begin.assign(nodes.size() + 1, 0);
  task.parallel_chunks(nodes.size(), node_chunk, [&](const ChunkRange& range) {
    Row& row = pieces[range.chunk];
    for (std::size_t p = range.begin; p < range.end; ++p) {
      std::size_t count = 0;
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link) {
        const Sender sender = links.senders[link];
        const Node &to = nodes[p], &from = nodes[sender.node()];
        const std::size_t before = row.senders.size();
        if (near_leaves(from, to)) {
          split(elements, hierarchy.element(to), hierarchy.element(from), sender, links.factors[link], way_between(from, to),
                row);
          row.counts.push_back(static_cast<std::uint32_t>(row.senders.size() - before));
          count += row.counts.back();
        } else {
          ++count;
        }
      }
      table.row_begin[p + 1] = static_cast<std::uint32_t>(count);
    }
  });
  for (std::size_t p = 0; p < nodes.size(); ++p) table.row_begin[p + 1] += table.row_begin[p];
  table.senders.resize(table.row_begin.back());
  table.factors.resize(table.row_begin.back());
  ways.resize(table.row_begin.back());
  task.parallel_chunks(nodes.size(), node_chunk, [&](const ChunkRange& range) {
    Row& row = pieces[range.chunk];
    std::size_t next = 0, split_links = 0, at = table.row_begin[range.begin];
    for (std::size_t p = range.begin; p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link) {
        const Node& from = nodes[links.senders[link].node()];
        if (!near_leaves(from, nodes[p])) {
          table.senders[at] = links.senders[link], table.factors[at] = links.factors[link];
          ways[at++] = way_between(from, nodes[p]);
          continue;
        }
        for (const std::size_t end = next + row.counts[split_links++]; next < end; ++next, ++at)
          table.senders[at] = row.senders[next], table.factors[at] = row.factors[next], ways[at] = row.ways[next];
      }
    row = {};
  });
  links = std::move(table);
}

}  // namespace gibench::antiradiance
