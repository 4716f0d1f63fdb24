#include "common/geometry/seen_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <optional>
#include <utility>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/core/vec.h"
#include "common/geometry/camera_sight.h"

namespace gibench {

namespace {

constexpr std::uint64_t stage_key = 0x7365656e63656cULL;
constexpr int rays_across = 128, reflections = 4;
constexpr float cells_along = 64.0F;

/// Points met by a bundle of rays, one for each; nothing where a ray meets none.
std::vector<std::optional<SurfaceSample>> trace(const World& world, const std::vector<Ray>& rays) {
  std::vector<Hit> hits(rays.size());
  world.rays().closest_hits(rays, hits);
  std::vector<std::optional<SurfaceSample>> met(rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i)
    if (hits[i]) met[i] = world.sample_of_hit(hits[i], rays[i].direction);
  return met;
}

/// What a camera meets, row by row.
std::vector<std::optional<SurfaceSample>> found_by_camera(const World& world, const CameraView& view) {
  std::vector<Ray> rays;
  const auto place = [](int i) { return (2.0F * static_cast<float>(i) + 1.0F) / static_cast<float>(rays_across) - 1.0F; };
  for (int y = 0; y < rays_across; ++y)
    for (int x = 0; x < rays_across; ++x) rays.push_back({view.position, 0.0F, view.direction_at(place(x), place(y))});
  return trace(world, rays);
}

/// Neighbours among what a camera meets: on a plane seen at a grazing angle they lie many cells apart.
void add_links(const std::vector<std::optional<SurfaceSample>>& met, std::vector<std::pair<Vec3, Vec3>>& links) {
  const std::size_t across = rays_across;
  const auto link = [&](std::size_t a, std::size_t b) {
    if (met[a] && met[b]) links.emplace_back(met[a]->position, met[b]->position);
  };
  for (std::size_t i = 0; i < met.size(); ++i) {
    if (i % across + 1 < across) link(i, i + 1);
    if (i + across < met.size()) link(i, i + across);
  }
}

std::vector<SurfaceSample> found_by_reflection(const World& world, const std::vector<SurfaceSample>& seen) {
  std::vector<Ray> rays;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i].lit_side) continue;
    RandomStream random(1, stage_key, i);
    const Frame frame(seen[i].normal);
    for (int r = 0; r < reflections; ++r) {
      const float u = random.next_float(), v = random.next_float();
      rays.push_back({world.ray_origin(seen[i]), 0.0F, frame.to_world(cosine_hemisphere({u, v}))});
    }
  }
  std::vector<SurfaceSample> found;
  for (const auto& met : trace(world, rays))
    if (met) found.push_back(*met);
  return found;
}

}  // namespace

SeenCells::SeenCells(const World& world) {
  std::vector<SurfaceSample> found;
  std::vector<std::pair<Vec3, Vec3>> links;
  for (const CameraView& view : camera_views(world.scene())) {
    const auto met = found_by_camera(world, view);
    add_links(met, links);
    for (const auto& sample : met)
      if (sample) found.push_back(*sample);
  }
  const std::vector<SurfaceSample> reflected = found_by_reflection(world, found);
  found.insert(found.end(), reflected.begin(), reflected.end());
  if (found.empty()) return;
  Vec3 high = low_ = found.front().position;
  for (const SurfaceSample& sample : found) low_ = glm::min(low_, sample.position), high = glm::max(high, sample.position);
  const Vec3 extent = high - low_;
  cell_size_ = std::max({extent.x, extent.y, extent.z, 1e-6F * world.diagonal()}) / cells_along;
  const auto count = [this](float length) { return static_cast<int>(length / cell_size_) + 1; };
  nx_ = count(extent.x), ny_ = count(extent.y), nz_ = count(extent.z);
  marked_.assign(static_cast<std::size_t>(nx_) * static_cast<std::size_t>(ny_) * static_cast<std::size_t>(nz_), 0);
  for (const SurfaceSample& sample : found) mark_around(cell_of(sample.position));
  for (const auto& [a, b] : links) {
    const int steps = static_cast<int>(glm::distance(a, b) / cell_size_) + 1;
    for (int s = 1; s < steps; ++s) mark_around(cell_of(glm::mix(a, b, static_cast<float>(s) / static_cast<float>(steps))));
  }
}

SeenCells::Cell SeenCells::cell_of(const Vec3& position) const {
  // Far away is out of the grid by one cell as well as by a million.
  const auto index = [this](float offset, int count) {
    return static_cast<int>(std::clamp(std::floor(offset / cell_size_), -2.0F, static_cast<float>(count) + 1.0F));
  };
  const Vec3 offset = position - low_;
  return {index(offset.x, nx_), index(offset.y, ny_), index(offset.z, nz_)};
}

void SeenCells::mark_around(const Cell& cell) {
  for (int z = std::max(0, cell.z - 1); z <= std::min(nz_ - 1, cell.z + 1); ++z)
    for (int y = std::max(0, cell.y - 1); y <= std::min(ny_ - 1, cell.y + 1); ++y)
      for (int x = std::max(0, cell.x - 1); x <= std::min(nx_ - 1, cell.x + 1); ++x)
        marked_[static_cast<std::size_t>((z * ny_ + y) * nx_ + x)] = 1;
}

bool SeenCells::is_marked(int x, int y, int z) const { return marked_[static_cast<std::size_t>((z * ny_ + y) * nx_ + x)] != 0; }

bool SeenCells::overlap(const Vec3& low, const Vec3& high) const {
  if (marked_.empty()) return false;
  const Cell first = cell_of(low), last = cell_of(high);
  for (int z = std::max(0, first.z); z <= std::min(nz_ - 1, last.z); ++z)
    for (int y = std::max(0, first.y); y <= std::min(ny_ - 1, last.y); ++y)
      for (int x = std::max(0, first.x); x <= std::min(nx_ - 1, last.x); ++x)
        if (is_marked(x, y, z)) return true;
  return false;
}

}  // namespace gibench
