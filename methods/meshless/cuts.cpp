#include "methods/meshless/cuts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "common/core/random.h"
#include "common/finite_elements/surface_point.h"
#include "methods/meshless/edge_frame.h"

namespace gibench::meshless {

namespace {

constexpr int directions = 4;          // around a point, evenly, turned by a random angle
constexpr float elevation = 0.5F;      // of the rays: what is lower than half its distance is no wall
constexpr float own_cosine = 0.5F;     // between normals of one surface that bends
constexpr float across_cosine = 0.7F;  // between the planes of two walls that cut a ball both, at most
constexpr std::size_t point_chunk = 256;
constexpr std::uint64_t turn_stage = 0x63757473ULL;

/// Of one function: the nearest walls.
class NearestWalls {
 public:
  void meet(const Vec3& place, const Vec3& normal, float distance) {
    if (distance < distance_[0]) {
      if (std::isfinite(distance_[0]) && stands_across(normal, cut_[0].normal)) cut_[1] = cut_[0], distance_[1] = distance_[0];
      cut_[0] = {normal, glm::dot(normal, place)};
      distance_[0] = distance;
      if (!stands_across(cut_[1].normal, normal)) cut_[1] = {}, distance_[1] = std::numeric_limits<float>::infinity();
    } else if (distance < distance_[1] && stands_across(normal, cut_[0].normal)) {
      cut_[1] = {normal, glm::dot(normal, place)};
      distance_[1] = distance;
    }
  }
  const std::array<Cut, cuts_of_a_function>& cuts() const { return cut_; }

 private:
  static bool stands_across(const Vec3& a, const Vec3& b) { return std::fabs(glm::dot(a, b)) < across_cosine; }

  std::array<Cut, cuts_of_a_function> cut_{};
  std::array<float, cuts_of_a_function> distance_{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
};

}  // namespace

void cut_at_walls(const World& world, Hierarchy& hierarchy, int last_levels, Task& task) {
  if (hierarchy.levels() < 2 || last_levels <= 0) return;
  const std::uint32_t first_level =
      hierarchy.levels() - std::min(hierarchy.levels() - 1, static_cast<std::uint32_t>(last_levels));
  const std::uint32_t begin = hierarchy.level_begin(first_level), end = hierarchy.size();
  std::vector<Cut> cuts(std::size_t{cuts_of_a_function} * (end - begin));
  task.parallel_chunks(end - begin, point_chunk, [&](const ChunkRange& range) {
    RayStream stream = task.rays(world);
    std::array<Ray, directions> rays;
    std::array<Hit, directions> hits;
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const std::uint32_t point = begin + static_cast<std::uint32_t>(i);
      const Vec3& front = world.normal(hierarchy.triangle(point));
      const Vec3 normal = hierarchy.on_front(point) ? front : -front;
      const SurfaceSample sample = surface_sample(world, hierarchy.triangle(point), hierarchy.position(point), normal);
      const Frame frame = frame_along_edge(world, hierarchy.triangle(point), normal);
      const float turn = RandomStream(task.seed(), turn_stage, point).next_float();
      for (int k = 0; k < directions; ++k) {
        const float angle = 2.0F * pi * (static_cast<float>(k) + turn) / directions;
        Ray& ray = rays[static_cast<std::size_t>(k)];
        ray = {world.ray_origin(sample), 0.0F, glm::normalize(frame.to_world(Vec3(std::cos(angle), std::sin(angle), elevation)))};
        ray.t_max = hierarchy.radius(point);
      }
      stream.closest_hits(rays, hits);
      NearestWalls walls;
      for (std::size_t k = 0; k < hits.size(); ++k) {
        if (!hits[k]) continue;
        const Vec3& met = world.normal(hits[k].triangle);
        const Vec3 facing = glm::dot(met, rays[k].direction) <= 0.0F ? met : -met;
        if (glm::dot(facing, normal) > own_cosine) continue;
        walls.meet(rays[k].origin + hits[k].distance * rays[k].direction, facing, hits[k].distance);
      }
      for (std::size_t which = 0; which < walls.cuts().size(); ++which)
        cuts[cuts_of_a_function * i + which] = walls.cuts()[which];
    }
  });
  hierarchy.set_cuts(first_level, std::move(cuts));
}

}  // namespace gibench::meshless
