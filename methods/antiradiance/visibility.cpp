#include "methods/antiradiance/visibility.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "common/core/random.h"
#include "common/core/sampling.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t node_chunk = 32, leaf_chunk = 64;
constexpr std::uint64_t link_stage = 0x6c696e6bULL, closure_stage = 0x636c6f73ULL;

std::size_t pick(float u, std::size_t count) {
  return std::min(count - 1, static_cast<std::size_t>(u * static_cast<float>(count)));
}

/// One at random, or the next that is not inside geometry: every element of the hierarchy has one.
const CellPoint& exposed_point(std::span<const CellPoint> points, float u) {
  std::size_t at = pick(u, points.size());
  while (!points[at].exposed) at = (at + 1) % points.size();
  return points[at];
}

/// Share of the segments of one link that are free; of those whose ends look away from each other nothing is learnt.
float free_share(const Elements& elements, const Hierarchy& hierarchy, const Node& to, const Sender& sender, int count,
                 RandomStream random, RayStream& rays) {
  const Node& from = hierarchy.nodes()[sender.node()];
  int tried = 0, open = 0;
  for (int ray = 0; ray < count; ++ray) {
    const auto element_of = [&](const Node& node) {
      return hierarchy.order()[node.begin + pick(random.next_float(), node.end - node.begin)];
    };
    const auto receiving = elements.points(element_of(to)), sending = elements.points(element_of(from));
    const CellPoint &end = exposed_point(receiving, random.next_float()), &start = exposed_point(sending, random.next_float());
    const Vec3 origin = sender.to_back() ? end.behind : end.origin, target = sender.from_back() ? start.behind : start.origin;
    const Vec3 way = target - origin;
    if ((glm::dot(way, end.normal) < 0.0F) != sender.to_back() || (glm::dot(way, start.normal) > 0.0F) != sender.from_back())
      continue;
    ++tried;
    if (!rays.occluded({origin, 0.0F, way, 1.0F})) ++open;
  }
  return tried > 0 ? static_cast<float>(open) / static_cast<float>(tried) : 1.0F;
}

/// Links without a factor go.
void take_out_blocked(LinkTable& links) {
  std::uint32_t kept = 0, link = 0;
  for (std::size_t row = 0; row + 1 < links.row_begin.size(); ++row) {
    const std::uint32_t end = links.row_begin[row + 1];
    links.row_begin[row] = kept;
    for (; link < end; ++link) {
      if (!(links.factors[link] > 0.0F)) continue;
      links.senders[kept] = links.senders[link];
      links.factors[kept] = links.factors[link];
      ++kept;
    }
  }
  links.row_begin.back() = kept;
  links.senders.resize(kept);
  links.factors.resize(kept);
}

}  // namespace

void trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, int rays, LinkTable& links,
                 Task& task) {
  task.parallel_chunks(hierarchy.size(), node_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (std::size_t p = range.begin; p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link)
        links.factors[link] *= free_share(elements, hierarchy, hierarchy.nodes()[p], links.senders[link], rays,
                                          RandomStream(task.seed(), link_stage, link), stream);
  });
  take_out_blocked(links);
}

std::vector<float> closed_shares(const World& world, const Elements& elements, const Hierarchy& hierarchy, int rays, Task& task) {
  std::vector<float> shares(hierarchy.leaf_count(), 0.0F);
  task.parallel_chunks(shares.size(), leaf_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (std::size_t leaf = range.begin; leaf < range.end; ++leaf) {
      const std::uint32_t element = hierarchy.order()[leaf];
      const auto points = elements.points(element);
      RandomStream random(task.seed(), closure_stage, element);
      const Vec2 shift{random.next_float(), random.next_float()};
      int closed = 0, tried = 0;
      for (int ray = 0; ray < rays; ++ray) {
        const CellPoint& point = points[static_cast<std::size_t>(ray) % points.size()];
        if (!point.exposed) continue;
        // A rank-1 lattice: the golden ratio against the ray's number.
        const Vec2 at{shift.x + static_cast<float>(ray) / static_cast<float>(rays),
                      shift.y + 0.61803398875F * static_cast<float>(ray)};
        const Vec3 direction = Frame(point.normal).to_world(cosine_hemisphere(at - glm::floor(at)));
        const Hit hit = stream.closest_hit({point.origin, 0.0F, direction});
        ++tried;
        if (hit && world.sample_of_hit(hit, direction).lit_side) ++closed;
      }
      shares[leaf] = tried > 0 ? static_cast<float>(closed) / static_cast<float>(tried) : 0.0F;
    }
  });
  return shares;
}

}  // namespace gibench::antiradiance
