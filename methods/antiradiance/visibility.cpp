#include "methods/antiradiance/visibility.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "common/core/random.h"
#include "common/core/sampling.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t node_chunk = 32, element_chunk = 64;
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

/// Two elements, one of which sees the other.
struct Sight {
  std::uint32_t from, to;
};

/// The sheets of what was hit: of a two-sided one both, as it is one surface to what lies behind.
void add_sights(const World& world, const SamplingMesh& mesh, std::uint32_t element, const SurfaceSample& seen,
                std::vector<Sight>& sights) {
  const bool front = glm::dot(seen.normal, world.normal(seen.triangle)) >= 0.0F;
  for (const bool side : {true, false}) {
    if (!mesh.covers(seen.triangle, side) || (side != front && mesh.covers(seen.triangle, front))) continue;
    const std::uint32_t other = mesh.triangles()[mesh.locate(seen.triangle, seen.barycentrics, side).triangle].corners[0];
    if (sights.empty() || sights.back().from != element || sights.back().to != other) sights.push_back({element, other});
  }
}

/// Joined by sights and by the faces of the mesh (union-find by the smallest).
std::vector<std::uint32_t> spaces_of(const SamplingMesh& mesh, std::size_t count, const std::vector<std::vector<Sight>>& sights) {
  std::vector<std::uint32_t> parent(count);
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    const std::uint32_t x = root(a), y = root(b);
    parent[std::max(x, y)] = std::min(x, y);
  };
  for (const MeshFace& face : mesh.faces())
    for (const std::uint32_t corner : face.corners) join(face.corners[0], corner);
  for (const std::vector<Sight>& some : sights)
    for (const Sight& sight : some) join(sight.from, sight.to);
  for (std::uint32_t i = 0; i < count; ++i) parent[i] = root(i);
  return parent;
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

Surroundings look_around(const World& world, const SamplingMesh& mesh, const Elements& elements, int rays, Task& task) {
  Surroundings found;
  found.closed.assign(elements.size(), 0.0F);
  std::vector<std::vector<Sight>> sights(chunk_count(elements.size(), element_chunk));
  task.parallel_chunks(elements.size(), element_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const auto element = static_cast<std::uint32_t>(i);
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
        if (!hit) continue;
        const SurfaceSample seen = world.sample_of_hit(hit, direction);
        if (seen.lit_side) ++closed;
        add_sights(world, mesh, element, seen, sights[range.chunk]);
      }
      found.closed[i] = tried > 0 ? static_cast<float>(closed) / static_cast<float>(tried) : 0.0F;
    }
  });
  found.space = spaces_of(mesh, elements.size(), sights);
  return found;
}

}  // namespace gibench::antiradiance
