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

constexpr int directions = 4;         // around a point, evenly, turned by a random angle
constexpr float elevation = 0.5F;     // of the rays: what is lower than half its distance is no wall
constexpr float own_cosine = 0.5F;    // between normals of one surface that bends
constexpr float other_cosine = 0.7F;  // between the normals of two walls that cut a ball both, at most
constexpr std::size_t point_chunk = 256;
constexpr std::uint64_t turn_stage = 0x63757473ULL;

/// Of one function: the nearest walls.
class NearestWalls {
 public:
  void meet(const Vec3& place, const Vec3& normal, float distance) {
    if (distance < distance_[0]) {
      if (std::isfinite(distance_[0]) && faces_elsewhere(normal, cut_[0].normal)) cut_[1] = cut_[0], distance_[1] = distance_[0];
      cut_[0] = {normal, glm::dot(normal, place)};
      distance_[0] = distance;
      if (!faces_elsewhere(cut_[1].normal, normal)) cut_[1] = {}, distance_[1] = std::numeric_limits<float>::infinity();
    } else if (distance < distance_[1] && faces_elsewhere(normal, cut_[0].normal)) {
      cut_[1] = {normal, glm::dot(normal, place)};
      distance_[1] = distance;
    }
  }
  const std::array<Cut, cuts_of_a_function>& cuts() const { return cut_; }

 private:
  /// Walls that face each other, as in a gap, are two.
  static bool faces_elsewhere(const Vec3& a, const Vec3& b) { return glm::dot(a, b) < other_cosine; }

  std::array<Cut, cuts_of_a_function> cut_{};
  std::array<float, cuts_of_a_function> distance_{std::numeric_limits<float>::infinity(), std::numeric_limits<float>::infinity()};
};

/// Looks around from points along their surfaces.
class WallFinder {
 public:
  WallFinder(const World& world, const Hierarchy& hierarchy, Task& task)
      : world_(world), hierarchy_(hierarchy), seed_(task.seed()), stream_(task.rays(world)) {}

  NearestWalls walls_around(std::uint32_t point) {
    const Vec3& front = world_.normal(hierarchy_.triangle(point));
    const Vec3 normal = hierarchy_.on_front(point) ? front : -front;
    aim_around(point, normal);
    stream_.closest_hits(rays_, hits_);
    NearestWalls walls;
    for (std::size_t k = 0; k < hits_.size(); ++k) {
      if (!hits_[k]) continue;
      const Vec3& met = world_.normal(hits_[k].triangle);
      const Vec3 facing = glm::dot(met, rays_[k].direction) <= 0.0F ? met : -met;
      if (glm::dot(facing, normal) > own_cosine) continue;
      walls.meet(rays_[k].origin + hits_[k].distance * rays_[k].direction, facing, hits_[k].distance);
    }
    return walls;
  }

 private:
  void aim_around(std::uint32_t point, const Vec3& normal) {
    const std::uint32_t triangle = hierarchy_.triangle(point);
    const Vec3 origin = world_.ray_origin(surface_sample(world_, triangle, hierarchy_.position(point), normal));
    const Frame frame = frame_along_edge(world_, triangle, normal);
    const float turn = RandomStream(seed_, turn_stage, point).next_float();
    for (std::size_t k = 0; k < rays_.size(); ++k) {
      const float angle = 2.0F * pi * (static_cast<float>(k) + turn) / directions;
      const Vec3 direction = frame.to_world(Vec3(std::cos(angle), std::sin(angle), elevation));
      rays_[k] = {origin, 0.0F, glm::normalize(direction), hierarchy_.radius(point)};
    }
  }

  const World& world_;
  const Hierarchy& hierarchy_;
  std::uint64_t seed_;
  RayStream stream_;
  std::array<Ray, directions> rays_;
  std::array<Hit, directions> hits_;
};

}  // namespace

void cut_at_walls(const World& world, Hierarchy& hierarchy, int last_levels, Task& task) {
  if (hierarchy.levels() < 2 || last_levels <= 0) return;
  const std::uint32_t cut_levels = std::min(hierarchy.levels() - 1, static_cast<std::uint32_t>(last_levels));
  const std::uint32_t first_level = hierarchy.levels() - cut_levels, begin = hierarchy.level_begin(first_level);
  std::vector<Cut> cuts(cuts_of_a_function * (hierarchy.size() - begin));
  task.parallel_chunks(hierarchy.size() - begin, point_chunk, [&](const ChunkRange& range) {
    WallFinder finder(world, hierarchy, task);
    for (std::size_t i = range.begin; i < range.end; ++i) {
      const NearestWalls walls = finder.walls_around(begin + static_cast<std::uint32_t>(i));
      std::copy(walls.cuts().begin(), walls.cuts().end(), &cuts[cuts_of_a_function * i]);
    }
  });
  hierarchy.set_cuts(first_level, std::move(cuts));
}

}  // namespace gibench::meshless
