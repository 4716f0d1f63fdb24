#include "methods/antiradiance/visibility.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "methods/antiradiance/reconstruction.h"

namespace gibench::antiradiance {

namespace {

constexpr std::size_t element_chunk = 64;
constexpr std::uint64_t closure_stage = 0x636c6f73ULL;

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

/// The element around what a ray met: that of the nearest corner of the mesh there; in a parted triangle of those alone that are
/// seen from there. None where nothing of the mesh lies on either side.
std::uint32_t element_met(const World& world, const SamplingMesh& mesh, const Elements& elements, const LookRule& rule,
                          const SurfaceSample& seen, RayStream& rays) {
  const bool front = glm::dot(seen.normal, world.normal(seen.triangle)) >= 0.0F;
  const bool side = mesh.covers(seen.triangle, front) ? front : !front;
  if (!mesh.covers(seen.triangle, side)) return no_element;
  const MeshPoint at = mesh.locate(seen.triangle, seen.barycentrics, side);
  std::optional<std::size_t> nearest = std::max_element(at.weights.begin(), at.weights.end()) - at.weights.begin();
  if (rule.is_parted(at.triangle) && side == front)
    nearest =
        Reconstruction::heaviest_seen(world, mesh, elements, seen, rays, Reconstruction::place(world, mesh, elements, seen));
  return nearest ? elements.of_vertex(mesh.triangles()[at.triangle].corners[*nearest]) : no_element;
}

}  // namespace

Surroundings look_around(const World& world, const SamplingMesh& mesh, const Elements& elements, const LookRule& rule,
                         Task& task) {
  Surroundings found;
  found.closed.assign(elements.size(), 0.0F);
  Spaces spaces(elements.size());
  const auto join = [&](std::uint32_t a, std::uint32_t b) {
    if (elements.is_sealed(a) == elements.is_sealed(b)) spaces.join(a, b);
  };
  for (std::size_t t = 0; t < mesh.triangles().size(); ++t) {
    if (rule.is_parted(t)) continue;
    const auto& corners = mesh.triangles()[t].corners;
    for (const std::uint32_t corner : corners) join(elements.of_vertex(corners[0]), elements.of_vertex(corner));
  }
  task.parallel_chunks(elements.size(), element_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const auto element = static_cast<std::uint32_t>(i);
      const auto points = elements.points(element);
      RandomStream random(task.seed(), closure_stage, element);
      const Vec2 shift{random.next_float(), random.next_float()};
      int closed = 0, tried = 0;
      for (int ray = 0; ray < rule.rays; ++ray) {
        const CellPoint& point = points[static_cast<std::size_t>(ray) % points.size()];
        if (!point.exposed) continue;
        // A rank-1 lattice: the golden ratio against the ray's number.
        const Vec2 at{shift.x + static_cast<float>(ray) / static_cast<float>(rule.rays),
                      shift.y + 0.61803398875F * static_cast<float>(ray)};
        const Vec3 direction = Frame(point.normal).to_world(cosine_hemisphere(at - glm::floor(at)));
        const Hit hit = stream.closest_hit({point.origin, 0.0F, direction});
        ++tried;
        if (!hit) continue;
        const SurfaceSample seen = world.sample_of_hit(hit, direction);
        if (seen.lit_side) ++closed;
        else if (!rule.over_black_backs) continue;
        const std::uint32_t met = element_met(world, mesh, elements, rule, seen, stream);
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
