#include "common/spaces/cell_points.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "common/core/error.h"
#include "common/core/random.h"
#include "common/core/sampling.h"

namespace gibench {

namespace {

constexpr std::uint64_t place_stage = 0x7370616365706c61ULL, another_stage = 0x7370616365616e6fULL;
constexpr int most_tries = 8;        // for a point that is not behind what coincides with it
constexpr float lift_share = 0.02F;  // of a cell's size: so far above it, what stands on it is looked for
constexpr std::size_t points_a_chunk = 256;
// Where a wall may cut off what lies beyond all points; a little inside, because others stand along the edges.
constexpr std::array<Vec2, 3> near_corners{Vec2(0.02F, 0.02F), Vec2(0.96F, 0.02F), Vec2(0.02F, 0.96F)};

/// A point of one of the four parts of a triangle: at its three corners, then the middle.
Vec2 in_part(std::uint32_t part, Vec2 place) {
  const Vec2 half = 0.5F * place;
  switch (part) {
    case 0: return half;
    case 1: return Vec2(0.5F, 0.0F) + half;
    case 2: return Vec2(0.0F, 0.5F) + half;
    default: return Vec2(0.5F) - half;
  }
}

std::uint32_t part_at(Vec2 place) {
  if (place.x > 0.5F) return 1;
  if (place.y > 0.5F) return 2;
  return place.x + place.y < 0.5F ? 0 : 3;
}

}  // namespace

CellPoints::CellPoints(const World& world, const SideCells& cells, std::uint32_t points_a_cell, Task& task)
    : world_(world), cells_(cells), points_a_cell_(points_a_cell), places_(cells.size() * points_a_cell, Vec2(-1.0F)) {
  GIBENCH_CHECK(points_a_cell == 1 || points_a_cell == 4, "a point for each part, or for the whole");
  task.parallel_chunks(places_.size(), points_a_chunk, [&](const ChunkRange& range) {
    for (auto point = static_cast<std::uint32_t>(range.begin); point < range.end; ++point) place(point, task.seed());
  });
  divided_.assign(cells.size(), 0);
  if (points_a_cell_ > 1) find_divided(task);
}

void CellPoints::place(std::uint32_t point, std::uint64_t seed) {
  const std::uint32_t of = cell(point);
  RandomStream random(seed, place_stage, point);
  for (int i = 0; i < most_tries; ++i) {
    const float u = random.next_float(), v = random.next_float();
    const Vec2 inside = uniform_triangle({u, v});
    const Vec2 tried = cells_.barycentrics(of, points_a_cell_ == 1 ? inside : in_part(point % points_a_cell_, inside));
    if (!shows(of, tried)) continue;
    places_[point] = glm::max(tried, Vec2(0.0F));
    return;
  }
}

void CellPoints::find_divided(Task& task) {
  task.parallel_chunks(cells_.size(), points_a_chunk, [&](const ChunkRange& range) {
    RayStream rays = task.rays(world_);
    for (auto of = static_cast<std::uint32_t>(range.begin); of < range.end; ++of) {
      const std::uint32_t first = of * points_a_cell_, middle = first + points_a_cell_ - 1;
      if (!exists(middle)) continue;
      const SurfaceSample centre = at(of, places_[middle]);
      for (std::uint32_t point = first; point < middle && divided_[of] == 0; ++point)
        if (exists(point) && !are_joined(of, centre, at(of, places_[point]), rays)) divided_[of] = 1;
      for (std::size_t corner = 0; corner < near_corners.size() && divided_[of] == 0; ++corner)
        if (!are_joined(of, centre, at(of, cells_.barycentrics(of, near_corners[corner])), rays)) divided_[of] = 1;
    }
  });
}

SurfaceSample CellPoints::at(std::uint32_t cell, Vec2 barycentrics) const {
  const std::uint32_t triangle = cells_.triangle(cell);
  SurfaceSample sample =
      world_.sample_at(triangle, barycentrics, cells_.front(cell) ? world_.normal(triangle) : -world_.normal(triangle));
  sample.lit_side = true;
  return sample;
}

bool CellPoints::shows(std::uint32_t cell, Vec2 barycentrics) const {
  const std::uint32_t triangle = cells_.triangle(cell);
  const Vec3 towards = cells_.front(cell) ? -world_.normal(triangle) : world_.normal(triangle);
  return world_.coincident().shows(triangle, barycentrics.x, barycentrics.y, towards);
}

std::optional<SurfaceSample> CellPoints::another(std::uint32_t cell, std::uint64_t number, std::uint64_t seed) const {
  RandomStream random(mix_keys(seed, number), another_stage, cell);
  const float u = random.next_float(), v = random.next_float();
  const Vec2 place = cells_.barycentrics(cell, uniform_triangle({u, v}));
  if (!shows(cell, place)) return std::nullopt;
  return at(cell, place);
}

std::optional<SurfaceSample> CellPoints::sample(std::uint32_t point) const {
  if (!exists(point)) return std::nullopt;
  return at(cell(point), places_[point]);
}

bool CellPoints::are_joined(std::uint32_t cell, const SurfaceSample& a, const SurfaceSample& b, RayStream& rays) const {
  const float lift = lift_share * std::sqrt(cells_.area(cell));
  const Vec3 from = a.position + std::max(lift, world_.offset(a)) * a.normal;
  const Vec3 to = b.position + std::max(lift, world_.offset(b)) * b.normal;
  return !rays.occluded({from, 0.0F, to - from, 1.0F});
}

std::uint32_t CellPoints::met(const Hit& hit, const Vec3& direction, RayStream& rays) const {
  if (!hit) return none;
  const Vec2 barycentrics(hit.u, hit.v);
  const std::uint32_t of = cells_.at(hit.triangle, glm::dot(world_.normal(hit.triangle), direction) <= 0.0F, barycentrics);
  if (of == SideCells::none) return none;
  const std::uint32_t first = of * points_a_cell_;
  const std::uint32_t nearest = points_a_cell_ == 1 ? 0 : part_at(cells_.place_in(of, barycentrics));
  if (!is_divided(of)) return first + nearest;
  const SurfaceSample place = at(of, barycentrics);
  for (std::uint32_t i = 0; i < points_a_cell_; ++i) {
    const std::uint32_t point = first + (nearest + i) % points_a_cell_;
    if (exists(point) && are_joined(of, place, at(of, places_[point]), rays)) return point;
  }
  return none;
}

}  // namespace gibench
