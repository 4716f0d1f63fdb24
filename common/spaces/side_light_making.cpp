#include "common/spaces/side_light_making.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include "common/core/random.h"
#include "common/core/sampling.h"
#include "common/geometry/camera_view.h"
#include "common/lighting/direct_light.h"
#include "common/scene/material_kinds.h"

namespace gibench {

namespace {

constexpr std::uint64_t straight_stage = 0x7370616365646972ULL, ray_stage = 0x7370616365726179ULL;
constexpr std::size_t most_rays_a_cell = 24, least_rays_a_cell = 4, usual_rays = 4'000'000;
constexpr int points_a_cell = 2;  // for straight light and for cameras
constexpr int most_tries = 8;     // for a point that is not behind what coincides with it
constexpr std::size_t cells_a_chunk = 128;
constexpr int camera_grid = 128;  // rays across and down a picture
constexpr int most_rounds = 32;
constexpr double settled_change = 1e-4;  // of the sum of irradiance

class CellLightMaker {
 public:
  CellLightMaker(const World& world, const SideCells& cells, Task& task)
      : world_(world), cells_(cells), task_(task), views_(camera_views(world.scene())) {
    light_.irradiance.assign(cells.size(), 0.0F);
    light_.seen.assign(cells.size(), 0);
  }

  CellLight make() {
    look_from_cameras();
    find_straight_light();
    trace_rays();
    reflect();
    return std::move(light_);
  }

 private:
  /// A random point of the cell that is not behind another surface.
  std::optional<SurfaceSample> point_of(std::uint32_t cell, RandomStream& random) const {
    const std::uint32_t triangle = cells_.triangle(cell);
    const Vec3 normal = cells_.front(cell) ? world_.normal(triangle) : -world_.normal(triangle);
    for (int i = 0; i < most_tries; ++i) {
      const float u = random.next_float(), v = random.next_float();
      const Vec2 place = cells_.barycentrics(cell, uniform_triangle({u, v}));
      if (!world_.coincident().shows(triangle, place.x, place.y, -normal)) continue;
      SurfaceSample sample = world_.sample_at(triangle, place, normal);
      sample.lit_side = true;  // light that arrives is wanted, whatever becomes of it
      return sample;
    }
    return std::nullopt;
  }

  void look_from_cameras() {
    for (const CameraView& view : views_) {
      task_.parallel_chunks(camera_grid, 1, [&](const ChunkRange& range) {
        RayStream rays = task_.rays(world_);
        std::array<Ray, camera_grid> row;
        std::array<Hit, camera_grid> hits;
        for (std::size_t x = 0; x < row.size(); ++x)
          row[x] = {view.position, 0.0F, view.direction_at(in_picture(x), in_picture(range.begin))};
        rays.closest_hits(row, hits);
        for (std::size_t x = 0; x < row.size(); ++x)
          if (const std::uint32_t cell = cell_of(hits[x], row[x].direction); cell != SideCells::none) mark_seen(cell);
      });
    }
  }
  static float in_picture(std::size_t i) { return (2.0F * static_cast<float>(i) + 1.0F) / camera_grid - 1.0F; }
  /// By several threads at once.
  void mark_seen(std::uint32_t cell) { std::atomic_ref(light_.seen[cell]).store(1, std::memory_order_relaxed); }

  std::uint32_t cell_of(const Hit& hit, const Vec3& direction) const {
    if (!hit) return SideCells::none;
    return cells_.at(hit.triangle, glm::dot(world_.normal(hit.triangle), direction) <= 0.0F, {hit.u, hit.v});
  }

  void find_straight_light() {
    const DirectLight light(world_, Lighting::of(world_.scene()));
    task_.parallel_chunks(cells_.size(), cells_a_chunk, [&](const ChunkRange& range) {
      RayStream rays = task_.rays(world_);
      std::vector<SurfaceSample> points;
      std::vector<std::uint64_t> keys;
      std::vector<std::uint32_t> cell_of_point;
      for (auto cell = static_cast<std::uint32_t>(range.begin); cell < range.end; ++cell) {
        RandomStream random(task_.seed(), straight_stage, cell);
        for (int i = 0; i < points_a_cell; ++i) {
          const std::optional<SurfaceSample> point = point_of(cell, random);
          if (!point) continue;
          points.push_back(*point);
          keys.push_back(random.next_bits());
          cell_of_point.push_back(cell);
        }
      }
      std::vector<Rgb> values(points.size());
      light.irradiance(points, keys, 1, rays, values);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint32_t cell = cell_of_point[i];
        light_.irradiance[cell] += mean_of_channels(values[i]) / points_a_cell;
        if (light_.seen[cell] == 0 && sees(points[i], rays)) light_.seen[cell] = 1;
      }
    });
  }
  static float mean_of_channels(const Rgb& value) { return (value.r + value.g + value.b) / 3.0F; }

  bool sees(const SurfaceSample& sample, RayStream& rays) const {
    for (const CameraView& view : views_) {
      if (!view.in_picture(sample.position) || !(glm::dot(view.position - sample.position, sample.normal) > 0.0F)) continue;
      const Vec3 origin = world_.ray_origin(sample);
      if (!rays.occluded({origin, 0.0F, view.position - origin, 1.0F})) return true;
    }
    return false;
  }

  /// The cells that the rays of each cell meet.
  void trace_rays() {
    rays_a_cell_ = std::clamp(usual_rays / std::max<std::size_t>(1, cells_.size()), least_rays_a_cell, most_rays_a_cell);
    met_.assign(cells_.size() * rays_a_cell_, SideCells::none);
    task_.parallel_chunks(cells_.size(), cells_a_chunk, [&](const ChunkRange& range) {
      RayStream stream = task_.rays(world_);
      std::vector<Ray> rays(rays_a_cell_);
      std::vector<Hit> hits(rays_a_cell_);
      for (auto cell = static_cast<std::uint32_t>(range.begin); cell < range.end; ++cell) {
        RandomStream random(task_.seed(), ray_stage, cell);
        if (!aim(cell, random, rays)) continue;
        stream.closest_hits(rays, hits);
        for (std::size_t i = 0; i < rays.size(); ++i) met_[cell * rays_a_cell_ + i] = cell_of(hits[i], rays[i].direction);
      }
    });
  }
  bool aim(std::uint32_t cell, RandomStream& random, std::span<Ray> rays) const {
    for (Ray& ray : rays) {
      const std::optional<SurfaceSample> point = point_of(cell, random);
      if (!point) return false;
      const float u = random.next_float(), v = random.next_float();
      ray = {world_.ray_origin(*point), 0.0F, Frame(point->normal).to_world(cosine_hemisphere({u, v}))};
    }
    return true;
  }

  std::span<const std::uint32_t> met_by(std::size_t cell) const {
    return std::span(met_).subspan(cell * rays_a_cell_, rays_a_cell_);
  }

  /// Rounds of reflections, and the one of what cameras see.
  void reflect() {
    const std::size_t count = cells_.size();
    std::vector<float> albedo(count), radiosity(count), next(count);
    std::vector<std::uint8_t> seen = light_.seen;
    const auto each_cell = [&](const auto& body) {
      task_.parallel_chunks(count, 16 * cells_a_chunk, [&](const ChunkRange& range) {
        for (auto cell = static_cast<std::uint32_t>(range.begin); cell < range.end; ++cell) body(cell);
      });
    };
    each_cell([&](std::uint32_t cell) {
      const std::uint32_t triangle = cells_.triangle(cell);
      if (!can_reflect(world_, triangle, cells_.front(cell))) return;
      albedo[cell] = mean_of_channels(straight_reflectance(world_.scene().material_of_triangle(triangle)));
      for (const std::uint32_t met : met_by(cell))
        if (met != SideCells::none && light_.seen[met] != 0) seen[cell] = 1;
    });
    const std::vector<float> straight = light_.irradiance;
    double sum = total(straight);
    for (int round = 0; round < most_rounds && !task_.cancelled(); ++round) {
      each_cell([&](std::uint32_t cell) { radiosity[cell] = albedo[cell] * light_.irradiance[cell]; });
      each_cell([&](std::uint32_t cell) {
        float arriving = 0.0F;
        for (const std::uint32_t met : met_by(cell))
          if (met != SideCells::none) arriving += radiosity[met];
        next[cell] = straight[cell] + arriving / static_cast<float>(rays_a_cell_);
      });
      light_.irradiance.swap(next);
      const double before = sum;
      sum = total(light_.irradiance);
      if (sum - before <= settled_change * sum) break;
    }
    light_.seen = std::move(seen);
  }
  double total(std::span<const float> irradiance) const {
    double sum = 0.0;
    for (std::uint32_t cell = 0; cell < irradiance.size(); ++cell)
      sum += static_cast<double>(irradiance[cell]) * static_cast<double>(cells_.area(cell));
    return sum;
  }

  const World& world_;
  const SideCells& cells_;
  Task& task_;
  std::vector<CameraView> views_;
  std::size_t rays_a_cell_ = most_rays_a_cell;
  std::vector<std::uint32_t> met_;  ///< cells, rays_a_cell_ of each; none: nothing, or a black back
  CellLight light_;
};

}  // namespace

CellLight light_of_cells(const World& world, const SideCells& cells, Task& task) {
  return CellLightMaker(world, cells, task).make();
}

bool can_reflect(const World& world, std::uint32_t triangle, bool front) {
  const Scene& scene = world.scene();
  return front || scene.objects[scene.triangle_object[triangle]].two_sided;
}

}  // namespace gibench
