#include "methods/antiradiance/visibility.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <span>
#include <vector>

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
float free_share(const Elements& elements, const Hierarchy& hierarchy, std::uint32_t to, const Sender& sender, int count,
                 RandomStream random, RayStream& rays) {
  int tried = 0, open = 0;
  for (int ray = 0; ray < count; ++ray) {
    const auto points_of = [&](std::uint32_t node) {
      return elements.points(hierarchy.element(hierarchy.leaf_by_area(node, random.next_float())));
    };
    const auto receiving = points_of(to), sending = points_of(sender.node());
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

/// Elements joined to spaces by all threads at once (union-find with compare-and-swap, Anderson and Woll 1991). Roots are
/// always the smallest of their space, so that what comes out does not depend on the order.
class Spaces {
 public:
  explicit Spaces(std::size_t count) : parents_(count) {
    for (std::uint32_t i = 0; i < count; ++i) parents_[i].store(i, std::memory_order_relaxed);
  }

  std::uint32_t root(std::uint32_t i) {
    std::uint32_t parent = parents_[i].load(std::memory_order_relaxed);
    while (parent != i) {
      const std::uint32_t above = parents_[parent].load(std::memory_order_relaxed);
      // Halves the path; should another thread have been faster, its parent is as good.
      if (above != parent) parents_[i].compare_exchange_weak(parent, above, std::memory_order_relaxed);
      i = above;
      parent = parents_[i].load(std::memory_order_relaxed);
    }
    return i;
  }

  void join(std::uint32_t a, std::uint32_t b) {
    while (true) {
      const std::uint32_t x = root(a), y = root(b);
      if (x == y) return;
      std::uint32_t expected = std::max(x, y);
      if (parents_[expected].compare_exchange_strong(expected, std::min(x, y), std::memory_order_relaxed)) return;
    }
  }

 private:
  std::vector<std::atomic<std::uint32_t>> parents_;
};

/// One element of the front of every scene triangle, and one of its back, or of the other side where a side has none; the
/// mesh's faces join it with all others there.
std::vector<std::array<std::uint32_t, 2>> element_of_sides(const World& world, const SamplingMesh& mesh,
                                                           const Elements& elements) {
  std::vector<std::array<std::uint32_t, 2>> result(world.scene().triangles.size(), {no_element, no_element});
  for (std::uint32_t triangle = 0; triangle < result.size(); ++triangle)
    for (const bool front : {true, false}) {
      const bool side = mesh.covers(triangle, front) ? front : !front;
      if (mesh.covers(triangle, side))
        result[triangle][front ? 0 : 1] =
            elements.of_vertex(mesh.triangles()[mesh.locate(triangle, Vec2(1.0F / 3.0F), side).triangle].corners[0]);
    }
  return result;
}

}  // namespace

void trace_links(const World& world, const Elements& elements, const Hierarchy& hierarchy, int rays, LinkTable& links,
                 Task& task) {
  task.parallel_chunks(hierarchy.size(), node_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (auto p = static_cast<std::uint32_t>(range.begin); p < range.end; ++p)
      for (std::uint32_t link = links.row_begin[p]; link < links.row_begin[p + 1]; ++link)
        links.factors[link] *=
            free_share(elements, hierarchy, p, links.senders[link], rays, RandomStream(task.seed(), link_stage, link), stream);
  });
  take_out_blocked(links);
}

Surroundings look_around(const World& world, const SamplingMesh& mesh, const Elements& elements, int rays, Task& task) {
  Surroundings found;
  found.closed.assign(elements.size(), 0.0F);
  Spaces spaces(elements.size());
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (elements.is_sealed(a) == elements.is_sealed(b)) spaces.join(a, b);
  };
  for (const MeshFace& face : mesh.faces())
    for (const std::uint32_t corner : face.corners) join(elements.of_vertex(face.corners[0]), elements.of_vertex(corner));
  const std::vector<std::array<std::uint32_t, 2>> sides = element_of_sides(world, mesh, elements);
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
        const bool front = glm::dot(seen.normal, world.normal(seen.triangle)) >= 0.0F;
        const std::uint32_t met = sides[seen.triangle][front ? 0 : 1];
        if (met != no_element) join(element, met);
      }
      found.closed[i] = tried > 0 ? static_cast<float>(closed) / static_cast<float>(tried) : 0.0F;
    }
  });
  found.space.resize(elements.size());
  for (std::uint32_t i = 0; i < elements.size(); ++i) found.space[i] = spaces.root(i);
  return found;
}

}  // namespace gibench::antiradiance
